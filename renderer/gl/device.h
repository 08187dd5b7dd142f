// What the passes need to know and have of a context.
#pragma once

#include <optional>

#include "renderer/gl/context.h"
#include "renderer/gl/stencil.h"
#include "renderer/gl/target.h"

namespace glimt::gl {

struct DrawState {
  bool adding = false;  // to what the target holds, instead of replacing it
  Limit limit = Limit::none;
};

class Device {
 public:
  // The context outlives the device. Errors: no_gl, when the context has no float target.
  explicit Device(Context& context);

  const Functions& gl() const { return *gl_; }
  const ContextInfo& info() const { return info_; }
  FloatForm floatForm() const { return float_form_; }
  int maxTextureSize() const { return max_texture_size_; }

  // Whether draws can be added to a float target.
  bool floatBlending() const { return float_blending_; }

  // How a float target gets a stencil; none where it cannot have one.
  std::optional<StencilForm> stencilForm() const { return stencil_form_; }

  // Runs the program in use once for each pixel of the tile of the bound target that the state lets
  // through.
  void draw(const Tile& tile, const DrawState& state = {}) const;

 private:
  void drawTriangle() const;

  const Functions* gl_;
  ContextInfo info_;
  FloatForm float_form_;
  std::optional<StencilForm> stencil_form_;
  int max_texture_size_ = 0;
  bool float_blending_ = false;
  BufferHandle triangle_;
};

}  // namespace glimt::gl
