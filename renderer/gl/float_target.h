// Which form of float texture a context can really draw into.
#pragma once

#include <optional>
#include <vector>

#include "renderer/gl/texture.h"

namespace glimt::gl {

enum class FloatTarget {
  incomplete,  // the context does not draw into it
  inexact,     // it does, but does not keep four full floats
  exact,
};

// Writes integers of 24 bits and reads them back. A framebuffer that calls itself complete proves
// nothing, since some drivers quietly give 8 bits.
FloatTarget tryFloatTarget(const Functions& gl, FloatForm form);

// The first of `forms` that is exact. None where no form is.
std::optional<FloatForm> findFloatForm(const Functions& gl, const std::vector<FloatForm>& forms);

}  // namespace glimt::gl
