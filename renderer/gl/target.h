// A texture that can be drawn into and read back.
#pragma once

#include <vector>

#include "renderer/gl/texture.h"

namespace glimt::gl {

class Target {
 public:
  Target() = default;

  // Errors: failed, when the device cannot draw into such a texture.
  explicit Target(Texture texture);

  int width() const { return texture_.width(); }
  int height() const { return texture_.height(); }
  const Texture& texture() const { return texture_; }

  // Draws go here, over the whole of it.
  void bind() const;

  // To zero.
  void clear() const;

  // Takes all marks off; see stencil.h.
  void clearStencil() const;

  // The whole content, rows from the bottom. Each for a texture of its kind. Errors: failed, when
  // the context gives it no more.
  std::vector<Vec4> readFloats() const;
  std::vector<unsigned char> readBytes() const;

 private:
  void read(GLenum type, void* texels) const;

  Texture texture_;
  FramebufferHandle framebuffer_;
};

}  // namespace glimt::gl
