#include "renderer/gl/query.h"

namespace glimt::gl {

Query::Query(const Functions& gl) {
  if (!gl.GenQueries) return;
  GLuint name = 0;
  gl.GenQueries(1, &name);
  handle_ = QueryHandle(gl, name);
}

void Query::begin() const {
  if (handle_) handle_.gl().BeginQuery(GL_ANY_SAMPLES_PASSED_EXT, handle_.name());
}

void Query::end() const {
  if (handle_) handle_.gl().EndQuery(GL_ANY_SAMPLES_PASSED_EXT);
}

bool Query::anyPassed() const {
  if (!handle_) return true;
  GLuint passed = GL_TRUE;  // also where the context is lost
  handle_.gl().GetQueryObjectuiv(handle_.name(), GL_QUERY_RESULT_EXT, &passed);
  return passed != GL_FALSE;
}

}  // namespace glimt::gl
