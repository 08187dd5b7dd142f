#include "renderer/gl/float_target.h"

#include "renderer/core/error.h"
#include "renderer/gl/target.h"

namespace glimt::gl {

FloatTarget tryFloatTarget(const Functions& gl, FloatForm form) {
  const Vec4 probe(16777215.0f, 16777213.0f, -16777215.0f, 1.0f / 16777215.0f);
  try {
    const Target target(Texture::floats(gl, form, 1, 1, {probe}));
    return target.readFloats()[0] == probe ? FloatTarget::exact : FloatTarget::inexact;
  } catch (const Error&) {
    return FloatTarget::incomplete;
  }
}

std::optional<FloatForm> findFloatForm(const Functions& gl, const std::vector<FloatForm>& forms) {
  for (const FloatForm form : forms)
    if (tryFloatTarget(gl, form) == FloatTarget::exact) return form;
  return std::nullopt;
}

}  // namespace glimt::gl
