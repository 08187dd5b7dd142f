// The one exception type of glimt.
#pragma once

#include <stdexcept>
#include <string>

namespace glimt {

// What an error means for the caller. The values are the exit statuses of the command line.
enum class ErrorKind {
  failed = 1,  // went wrong while running
  usage = 2,   // asked for something that does not exist
  input = 3,   // a file that cannot be used
  no_gl = 4,   // no context that can render
};

// `message` is one line: where, what is wrong, and what to do about it.
class Error : public std::runtime_error {
 public:
  Error(ErrorKind kind, const std::string& message) : std::runtime_error(message), kind_(kind) {}

  ErrorKind kind() const { return kind_; }

 private:
  ErrorKind kind_;
};

}  // namespace glimt
