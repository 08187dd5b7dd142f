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

// Attaches the textures to the framebuffer that is bound, in their order.
void attach(const Functions& gl, const std::vector<Texture>& textures) {
  std::vector<GLenum> attachments;
  for (const Texture& texture : textures) {
    const auto attachment = GL_COLOR_ATTACHMENT0 + static_cast<GLenum>(attachments.size());
    gl.FramebufferTexture2D(GL_FRAMEBUFFER, attachment, GL_TEXTURE_2D, texture.name(), 0);
    attachments.push_back(attachment);
  }
  if (attachments.size() == 1) return;  // where draws go by themselves
  if (!gl.DrawBuffers)
    throw Error(ErrorKind::failed, "several textures cannot be drawn into at once in this context");
  gl.DrawBuffers(static_cast<GLsizei>(attachments.size()), attachments.data());
}

std::vector<Texture> listOf(Texture texture) {
  std::vector<Texture> list;
  list.push_back(std::move(texture));
  return list;
}

}  // namespace

Target::Target(Texture texture) : Target(listOf(std::move(texture))) {}

Target::Target(std::vector<Texture> textures)
    : textures_(std::move(textures)), framebuffer_(generate(textures_.at(0).gl())) {
  const Functions& gl = framebuffer_.gl();
  gl.BindFramebuffer(GL_FRAMEBUFFER, framebuffer_.name());
  attach(gl, textures_);
  const GLenum status = gl.CheckFramebufferStatus(GL_FRAMEBUFFER);
  if (status != GL_FRAMEBUFFER_COMPLETE)
    throw Error(ErrorKind::failed, fmt::format("a target of {} x {} is not complete (GL 0x{:04x})",
                                               width(), height(), status));
}

void Target::bind() const {
  const Functions& gl = framebuffer_.gl();
  gl.BindFramebuffer(GL_FRAMEBUFFER, framebuffer_.name());
  gl.Viewport(0, 0, width(), height());
}

void Target::clear() const {
  const Functions& gl = framebuffer_.gl();
  bind();
  gl.Disable(GL_SCISSOR_TEST);
  gl.ClearColor(0, 0, 0, 0);
  gl.Clear(GL_COLOR_BUFFER_BIT);
}

void Target::clear(const Tile& tile, const Vec4& value) const {
  const Functions& gl = framebuffer_.gl();
  bind();
  gl.Enable(GL_SCISSOR_TEST);
  gl.Scissor(tile.x, tile.y, tile.width, tile.height);
  gl.ClearColor(value.r, value.g, value.b, value.a);
  gl.Clear(GL_COLOR_BUFFER_BIT);
}

void Target::mark(const Tile& tile) const {
  const Functions& gl = framebuffer_.gl();
  bind();
  gl.Enable(GL_SCISSOR_TEST);
  gl.Scissor(tile.x, tile.y, tile.width, tile.height);
  gl.ClearStencil(1);
  gl.Clear(GL_STENCIL_BUFFER_BIT);
  gl.ClearStencil(0);
}

void Target::clearStencil() const {
  const Functions& gl = framebuffer_.gl();
  bind();
  gl.Disable(GL_SCISSOR_TEST);
  gl.Clear(GL_STENCIL_BUFFER_BIT);
}

void Target::read(GLenum type, void* texels) const {
  const Functions& gl = framebuffer_.gl();
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
