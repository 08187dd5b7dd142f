// A shared library that is opened at run time, so that glimt starts where it is missing.
#pragma once

#include <memory>
#include <string>

namespace glimt::gl {

class SharedLibrary {
 public:
  // Symbols stay local, so that libraries which define the same names can live side by side.
  // Errors: no_gl, with the dynamic linker's own words.
  explicit SharedLibrary(const std::string& name);

  // Null where the library has no such symbol.
  void* find(const char* symbol) const;

  // Errors: no_gl, naming the symbol.
  template <class Function>
  Function require(const char* symbol) const {
    return reinterpret_cast<Function>(findOrThrow(symbol));
  }

 private:
  void* findOrThrow(const char* symbol) const;

  struct Close {
    void operator()(void* handle) const;
  };
  std::string name_;
  std::unique_ptr<void, Close> handle_;
};

}  // namespace glimt::gl
