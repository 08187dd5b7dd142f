#include "renderer/gl/functions.h"

#include <string>

#include "renderer/core/error.h"

namespace glimt::gl {

Functions Functions::load(const ProcLoader& loader) {
  Functions table;
#define GLIMT_GL_LOAD(name, type)                          \
  table.name = reinterpret_cast<type>(loader("gl" #name)); \
  if (!table.name)                                         \
    throw Error(ErrorKind::no_gl,                          \
                "the context has no gl" #name              \
                "; OpenGL ES 2.0 or desktop GL with ARB_ES2_compatibility is needed");
  GLIMT_GL_FUNCTIONS(GLIMT_GL_LOAD)
#undef GLIMT_GL_LOAD
#define GLIMT_GL_LOAD_OPTIONAL(name, type) table.name = reinterpret_cast<type>(loader("gl" #name));
  GLIMT_GL_OPTIONAL_FUNCTIONS(GLIMT_GL_LOAD_OPTIONAL)
#undef GLIMT_GL_LOAD_OPTIONAL
  return table;
}

}  // namespace glimt::gl
