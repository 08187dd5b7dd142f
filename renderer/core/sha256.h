// SHA-256, as sha256sum prints it.
#pragma once

#include <memory>
#include <string>
#include <string_view>

namespace glimt {

class Sha256 {
 public:
  Sha256();
  Sha256(const Sha256&) = delete;
  Sha256& operator=(const Sha256&) = delete;
  ~Sha256();

  void add(std::string_view bytes);

  // Of all that was added, 64 hexadecimal digits. Nothing can be added after it.
  std::string digest();

 private:
  struct Context;
  std::unique_ptr<Context> context_;
};

std::string sha256Of(std::string_view bytes);

}  // namespace glimt
