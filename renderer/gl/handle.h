// Owns one GL object.
#pragma once

#include <utility>

#include "renderer/gl/functions.h"

namespace glimt::gl {

// `Delete` is called with the functions and the object's name when the handle goes. The context
// outlives every handle made from it.
template <class Delete>
class Handle {
 public:
  Handle() = default;
  Handle(const Functions& gl, GLuint name) : gl_(&gl), name_(name) {}
  Handle(Handle&& other) noexcept
      : gl_(std::exchange(other.gl_, nullptr)), name_(std::exchange(other.name_, 0)) {}
  Handle& operator=(Handle&& other) noexcept {
    std::swap(gl_, other.gl_);
    std::swap(name_, other.name_);
    return *this;
  }
  ~Handle() {
    if (name_) Delete{}(*gl_, name_);
  }

  const Functions& gl() const { return *gl_; }
  GLuint name() const { return name_; }
  explicit operator bool() const { return name_ != 0; }

 private:
  const Functions* gl_ = nullptr;
  GLuint name_ = 0;
};

struct DeleteTexture {
  void operator()(const Functions& gl, GLuint name) const { gl.DeleteTextures(1, &name); }
};
struct DeleteFramebuffer {
  void operator()(const Functions& gl, GLuint name) const { gl.DeleteFramebuffers(1, &name); }
};
struct DeleteRenderbuffer {
  void operator()(const Functions& gl, GLuint name) const { gl.DeleteRenderbuffers(1, &name); }
};
struct DeleteBuffer {
  void operator()(const Functions& gl, GLuint name) const { gl.DeleteBuffers(1, &name); }
};
struct DeleteQuery {
  void operator()(const Functions& gl, GLuint name) const { gl.DeleteQueries(1, &name); }
};
struct DeleteShader {
  void operator()(const Functions& gl, GLuint name) const { gl.DeleteShader(name); }
};
struct DeleteProgram {
  void operator()(const Functions& gl, GLuint name) const { gl.DeleteProgram(name); }
};

using TextureHandle = Handle<DeleteTexture>;
using FramebufferHandle = Handle<DeleteFramebuffer>;
using RenderbufferHandle = Handle<DeleteRenderbuffer>;
using BufferHandle = Handle<DeleteBuffer>;
using QueryHandle = Handle<DeleteQuery>;
using ShaderHandle = Handle<DeleteShader>;
using ProgramHandle = Handle<DeleteProgram>;

}  // namespace glimt::gl
