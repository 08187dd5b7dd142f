// Marks on the pixels of a target, by which draws are limited to the others.
#pragma once

#include <optional>

#include "renderer/gl/target.h"

namespace glimt::gl {

// How a context wants a stencil to be asked for.
enum class StencilForm {
  alone,       // STENCIL_INDEX8: ES 2.0
  with_depth,  // DEPTH24_STENCIL8: where a stencil cannot be had alone
};

class Stencil {
 public:
  Stencil() = default;
  Stencil(const Functions& gl, StencilForm form, int width, int height);

  // Makes it the stencil of a target of the same size; several targets may share one. Errors:
  // failed, when the device cannot draw into the two together.
  void attachTo(const Target& target) const;

 private:
  RenderbufferHandle handle_;
  StencilForm form_ = StencilForm::alone;
};

// Which pixels of a target with a stencil a draw is for.
enum class Limit {
  none,      // all of them
  unmarked,  // drivers look before they run the shader: marked pixels cost next to nothing
  unmarked_then_mark,  // and those that the shader does not discard are marked
};

// The first form that goes together with a target of floats. None where there is none.
std::optional<StencilForm> findStencilForm(const Functions& gl, FloatForm float_form);

}  // namespace glimt::gl
