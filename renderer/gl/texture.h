// Textures that hold numbers.
#pragma once

#include <cstdint>
#include <vector>

#include "renderer/core/vector.h"
#include "renderer/gl/handle.h"

namespace glimt::gl {

// How a context wants four floats per texel to be asked for.
enum class FloatForm {
  sized,    // GL_RGBA32F: ES 3, Mesa's ES 2, desktop GL
  unsized,  // GL_RGBA with GL_FLOAT: WebGL 1, ES 2 with OES_texture_float; 8 bits on some desktop
            // GL
};

// Nearest filter, no mipmaps. Coordinates repeat where both sizes are powers of two and are clamped
// where not, which is what OpenGL ES 2.0 allows.
class Texture {
 public:
  Texture() = default;

  // Four floats a texel. `texels` has width * height elements, rows from the bottom, or none: then
  // the content is undefined. Errors: failed, when the device cannot make it.
  static Texture floats(const Functions& gl, FloatForm form, int width, int height,
                        const std::vector<Vec4>& texels = {});

  // Four bytes a texel. `texels` has 4 * width * height elements, or none: then the content is
  // undefined. Errors: as above.
  static Texture bytes(const Functions& gl, int width, int height,
                       const std::vector<std::uint8_t>& texels = {});

  int width() const { return width_; }
  int height() const { return height_; }
  GLuint name() const { return handle_.name(); }
  const Functions& gl() const { return handle_.gl(); }

  // Makes it the texture of a unit.
  void bind(int unit) const;

 private:
  Texture(const Functions& gl, GLint internal_format, GLenum type, int width, int height,
          const void* texels);

  TextureHandle handle_;
  int width_ = 0;
  int height_ = 0;
};

}  // namespace glimt::gl
