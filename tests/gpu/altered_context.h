// A real context with some of its functions replaced: a driver that does something wrong.
#pragma once

#include <functional>
#include <memory>

#include "renderer/gl/context.h"

namespace glimt::test {

// `alter` changes the functions of `real`, which stays current and outlives what comes back. The
// altered context is one of its own for everything that asks it. It has GetGraphicsResetStatus only
// where its extensions say so.
inline std::unique_ptr<gl::Context> alteredContext(
    const gl::Context& real, const std::function<void(gl::Functions&)>& alter) {
  gl::Functions functions = real.functions();
  alter(functions);
  return gl::adoptContext([functions](const char* name) -> void* {
#define GLIMT_GL_FIND(member, type) \
  if (std::string("gl" #member) == name) return reinterpret_cast<void*>(functions.member);
    GLIMT_GL_FUNCTIONS(GLIMT_GL_FIND)
#undef GLIMT_GL_FIND
    if (std::string(name).starts_with("glGetGraphicsResetStatus"))
      return reinterpret_cast<void*>(functions.GetGraphicsResetStatus);
    return nullptr;
  });
}

}  // namespace glimt::test
