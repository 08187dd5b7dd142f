#include "renderer/scene/obj_lines.h"

#include <fmt/format.h>

#include <algorithm>

#include "renderer/core/error.h"

namespace glimt {
namespace {

constexpr std::string_view kBlanks = " \t\v\f";

std::string_view trimmed(std::string_view text) {
  const std::size_t first = text.find_first_not_of(kBlanks);
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(kBlanks) - first + 1);
}

// Names may contain '#'; so do the infinities of some compilers, "1.#INF".
std::string_view withoutRemark(std::string_view line) {
  if (!line.starts_with('v') && !line.starts_with('f')) return line;
  return trimmed(line.substr(0, std::min(line.find(" #"), line.find("\t#"))));
}

}  // namespace

std::string_view ObjLines::takeRawLine() {
  const std::size_t length = std::min(rest_.find_first_of("\r\n"), rest_.size());
  const std::string_view line = rest_.substr(0, length);
  const bool two_bytes = rest_.substr(length, 2) == "\r\n";
  rest_.remove_prefix(std::min(length + (two_bytes ? 2 : 1), rest_.size()));
  ++taken_;
  return line;
}

ObjLines::int_type ObjLines::underflow() {
  if (rest_.empty()) return traits_type::eof();
  number_ = taken_ + 1;
  std::string_view raw = takeRawLine();
  line_ = trimmed(raw);
  while (raw.ends_with('\\') && !raw.starts_with('#') && !rest_.empty()) {
    line_.back() = ' ';
    raw = takeRawLine();
    line_ += trimmed(raw);
  }
  line_ = std::string(withoutRemark(line_));
  line_ += '\n';
  setg(line_.data(), line_.data(), line_.data() + line_.size());
  return traits_type::to_int_type(*gptr());
}

std::string_view demandText(std::string_view bytes, const std::string& path) {
  if (bytes.starts_with("\xef\xbb\xbf")) bytes.remove_prefix(3);
  if (bytes.starts_with("\xfe\xff") || bytes.starts_with("\xff\xfe")) {
    throw Error(ErrorKind::input,
                fmt::format("{}:1: the text is in UTF-16; save it as UTF-8", path));
  }
  const std::size_t zero = bytes.find('\0');
  if (zero != std::string_view::npos) {
    const auto line = 1 + std::count(bytes.begin(), bytes.begin() + static_cast<long>(zero), '\n');
    throw Error(ErrorKind::input,
                fmt::format("{}:{}: not a text file; export the model again, as OBJ", path, line));
  }
  return bytes;
}

}  // namespace glimt
