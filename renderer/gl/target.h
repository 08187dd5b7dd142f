// Textures that can be drawn into and read back.
#pragma once

#include <vector>

#include "renderer/gl/texture.h"

namespace glimt::gl {

// A rectangle of pixels, counted from the bottom left.
struct Tile {
  int x = 0;
  int y = 0;
  int width = 0;
  int height = 0;
};

class Target {
 public:
  Target() = default;

  // Errors: failed, when the device cannot draw into such a texture.
  explicit Target(Texture texture);

  // Textures of one size, which a draw writes to at once: output i of the shader goes to texture i.
  // Errors: failed, also when there is more than one and the context is of ES 2.0.
  explicit Target(std::vector<Texture> textures);

  int width() const { return textures_.empty() ? 0 : textures_.front().width(); }
  int height() const { return textures_.empty() ? 0 : textures_.front().height(); }
  const Texture& texture(std::size_t i = 0) const { return textures_.at(i); }

  // Draws go here, over the whole of it.
  void bind() const;

  // To zero, or a part of it to a value.
  void clear() const;
  void clear(const Tile& tile, const Vec4& value) const;

  // Takes all marks off; see stencil.h.
  void clearStencil() const;

  // Marks the pixels of a part.
  void mark(const Tile& tile) const;

  // The whole content of the first texture, rows from the bottom. Each for a texture of its kind.
  // Errors: failed, when the context gives it no more.
  std::vector<Vec4> readFloats() const;
  std::vector<unsigned char> readBytes() const;

 private:
  void read(GLenum type, void* texels) const;

  std::vector<Texture> textures_;
  FramebufferHandle framebuffer_;
};

}  // namespace glimt::gl
