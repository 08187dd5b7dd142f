// The text of an OBJ or MTL file as the lines that tinyobjloader should see.
#pragma once

#include <istream>
#include <streambuf>
#include <string>
#include <string_view>

namespace glimt {

// Serves one line at a time, so that whoever reads knows which one it is on. Lines may end as on
// any system; one that ends in a backslash goes on in the next; white space at the ends is gone;
// remarks behind vertices and faces are gone, too.
class ObjLines : public std::streambuf {
 public:
  // `text` has to outlive the lines.
  explicit ObjLines(std::string_view text) : rest_(text) {}

  // Of the line that was handed out last: its text, and its number, counted from 1.
  std::string_view line() const { return std::string_view(line_).substr(0, line_.size() - 1); }
  std::size_t number() const { return number_; }

 protected:
  int_type underflow() override;

 private:
  std::string_view takeRawLine();

  std::string_view rest_;
  std::string line_ = "\n";
  std::size_t number_ = 0;
  std::size_t taken_ = 0;
};

// UTF-8 without its byte order mark. Errors: input, "PATH:LINE: what; what to do", for UTF-16 and
// for bytes that are no text.
std::string_view demandText(std::string_view bytes, const std::string& path);

}  // namespace glimt
