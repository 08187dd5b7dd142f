#include "app/message.h"

#include <algorithm>
#include <cstdio>
#include <string>

namespace glimt {

void say(std::string_view text) {
  std::string line("glimt: ");
  line += text;
  sayPlain(line);
}

void sayPlain(std::string_view text) {
  std::string line(text);
  const auto is_control = [](unsigned char c) { return c < 0x20 || c == 0x7f; };
  std::replace_if(line.begin(), line.end(), is_control, ' ');
  line += '\n';
  std::fwrite(line.data(), 1, line.size(), stderr);
}

}  // namespace glimt
