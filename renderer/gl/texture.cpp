#include "renderer/gl/texture.h"

#include <fmt/format.h>

#include "renderer/gl/errors.h"

namespace glimt::gl {
namespace {

constexpr GLint kRgba32f = 0x8814;  // GL_RGBA32F, which ES 2.0's header does not know

bool isPowerOfTwo(int n) {
  return (n & (n - 1)) == 0;
}

TextureHandle generate(const Functions& gl) {
  GLuint name = 0;
  gl.GenTextures(1, &name);
  return {gl, name};
}

}  // namespace

Texture::Texture(const Functions& gl, GLint internal_format, GLenum type, int width, int height,
                 const void* texels)
    : handle_(generate(gl)), width_(width), height_(height) {
  bind(0);
  clearErrors(gl);
  gl.TexImage2D(GL_TEXTURE_2D, 0, internal_format, width, height, 0, GL_RGBA, type, texels);
  checkErrors(gl, fmt::format("making a texture of {} x {}", width, height));
  const GLint wrap = isPowerOfTwo(width) && isPowerOfTwo(height) ? GL_REPEAT : GL_CLAMP_TO_EDGE;
  gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, wrap);
  gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, wrap);
  gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
  gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
}

Texture Texture::floats(const Functions& gl, FloatForm form, int width, int height,
                        const std::vector<Vec4>& texels) {
  const GLint internal_format = form == FloatForm::sized ? kRgba32f : GL_RGBA;
  return {gl, internal_format, GL_FLOAT, width, height, texels.empty() ? nullptr : texels.data()};
}

Texture Texture::bytes(const Functions& gl, int width, int height,
                       const std::vector<std::uint8_t>& texels) {
  return {gl, GL_RGBA, GL_UNSIGNED_BYTE, width, height, texels.empty() ? nullptr : texels.data()};
}

void Texture::bind(int unit) const {
  gl().ActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(unit));
  gl().BindTexture(GL_TEXTURE_2D, name());
}

}  // namespace glimt::gl
