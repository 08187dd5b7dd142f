#include "renderer/gl/target.h"

#include <fmt/format.h>

#include "renderer/gl/errors.h"

namespace glimt::gl {
namespace {

FramebufferHandle generate(const Functions& gl) {
  GLuint name = 0;
  gl.GenFramebuffers(1, &name);
  return {gl, name};
}

}  // namespace

Target::Target(Texture texture)
    : texture_(std::move(texture)), framebuffer_(generate(texture_.gl())) {
  const Functions& gl = texture_.gl();
  gl.BindFramebuffer(GL_FRAMEBUFFER, framebuffer_.name());
  gl.FramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, texture_.name(), 0);
  const GLenum status = gl.CheckFramebufferStatus(GL_FRAMEBUFFER);
  if (status != GL_FRAMEBUFFER_COMPLETE)
    throw Error(ErrorKind::failed, fmt::format("a target of {} x {} is not complete (GL 0x{:04x})",
                                               width(), height(), status));
}

void Target::bind() const {
  const Functions& gl = texture_.gl();
  gl.BindFramebuffer(GL_FRAMEBUFFER, framebuffer_.name());
  gl.Viewport(0, 0, width(), height());
}

void Target::clear() const {
  const Functions& gl = texture_.gl();
  bind();
  gl.Disable(GL_SCISSOR_TEST);
  gl.ClearColor(0, 0, 0, 0);
  gl.Clear(GL_COLOR_BUFFER_BIT);
}

void Target::clearStencil() const {
  const Functions& gl = texture_.gl();
  bind();
  gl.Disable(GL_SCISSOR_TEST);
  gl.Clear(GL_STENCIL_BUFFER_BIT);
}

void Target::read(GLenum type, void* texels) const {
  const Functions& gl = texture_.gl();
  bind();
  clearErrors(gl);
  gl.ReadPixels(0, 0, width(), height(), GL_RGBA, type, texels);
  checkErrors(gl, fmt::format("reading back a picture of {} x {}", width(), height()));
}

std::vector<Vec4> Target::readFloats() const {
  std::vector<Vec4> texels(static_cast<std::size_t>(width()) * height());
  read(GL_FLOAT, texels.data());
  return texels;
}

std::vector<unsigned char> Target::readBytes() const {
  std::vector<unsigned char> bytes(static_cast<std::size_t>(width()) * height() * 4);
  read(GL_UNSIGNED_BYTE, bytes.data());
  return bytes;
}

}  // namespace glimt::gl
