#include "app/progress.h"

#include <fmt/format.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <string>

namespace glimt {
namespace {

constexpr std::chrono::milliseconds kInterval{100};

// A line that wraps could not be rewritten with a carriage return.
std::size_t columns() {
  winsize size{};
  if (ioctl(STDERR_FILENO, TIOCGWINSZ, &size) != 0 || size.ws_col < 2) return 79;
  return size.ws_col - 1u;
}

}  // namespace

Progress::Progress(bool wanted) : enabled_(wanted && isatty(STDERR_FILENO) == 1) {}

Progress::~Progress() {
  clear();
}

void Progress::show(std::string_view text) {
  if (!enabled_) return;
  write(text.substr(0, columns()));
  last_ = std::chrono::steady_clock::now();
}

bool Progress::due() const {
  return enabled_ && std::chrono::steady_clock::now() - last_ >= kInterval;
}

void Progress::clear() {
  if (shown_ == 0) return;
  write("");
  std::fputc('\r', stderr);
}

void showTree(Progress& progress, float fraction) {
  if (fraction == 1)
    progress.show("compiling the shaders");
  else if (progress.due())
    progress.show(fmt::format("building the tree, {:.0f}%", 100 * fraction));
}

void Progress::write(std::string_view text) {
  std::string line(1, '\r');
  line += text;
  if (shown_ > text.size()) line.append(shown_ - text.size(), ' ');
  std::fwrite(line.data(), 1, line.size(), stderr);
  std::fflush(stderr);
  shown_ = text.size();
}

}  // namespace glimt
