// What the passes need to know and have of a context.
#pragma once

#include "renderer/gl/context.h"
#include "renderer/gl/target.h"

namespace glimt::gl {

// A rectangle of pixels, counted from the bottom left.
struct Tile {
  int x = 0;
  int y = 0;
  int width = 0;
  int height = 0;
};

class Device {
 public:
  // The context outlives the device. Errors: no_gl, when the context has no float target.
  explicit Device(Context& context);

  const Functions& gl() const { return *gl_; }
  const ContextInfo& info() const { return info_; }
  FloatForm floatForm() const { return float_form_; }
  int maxTextureSize() const { return max_texture_size_; }

  // Whether draws can be added to a float target (drawAdding).
  bool floatBlending() const { return float_blending_; }

  // Runs the program in use once for each pixel of the tile of the bound target.
  void draw(const Tile& tile) const;

  // The same, adding to what the target holds.
  void drawAdding(const Tile& tile) const;

 private:
  const Functions* gl_;
  ContextInfo info_;
  FloatForm float_form_;
  int max_texture_size_ = 0;
  bool float_blending_ = false;
  BufferHandle triangle_;
};

}  // namespace glimt::gl
