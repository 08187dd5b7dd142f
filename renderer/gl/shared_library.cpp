#include "renderer/gl/shared_library.h"

#include <dlfcn.h>

#include "renderer/core/error.h"

namespace glimt::gl {

SharedLibrary::SharedLibrary(const std::string& name)
    : name_(name), handle_(dlopen(name.c_str(), RTLD_NOW | RTLD_LOCAL)) {
  if (!handle_) throw Error(ErrorKind::no_gl, dlerror());
}

void* SharedLibrary::find(const char* symbol) const {
  return dlsym(handle_.get(), symbol);
}

void* SharedLibrary::findOrThrow(const char* symbol) const {
  void* address = find(symbol);
  if (!address) throw Error(ErrorKind::no_gl, name_ + " has no " + symbol);
  return address;
}

void SharedLibrary::Close::operator()(void* handle) const {
  dlclose(handle);
}

}  // namespace glimt::gl
