// What a device does with sums in a target, with values that are not finite, and with tiny ones.
#pragma once

#include "renderer/gl/device.h"

namespace glimt {

// Whether gl::Device::drawAdding adds to a target as floats add. For a device with floatBlending().
bool addsExactly(const gl::Device& device);

// Whether comparisons tell NaN, infinities and negative values from radiance, as accumulate.glsl
// wants: ES 2.0 has no isnan.
bool detectsNonfinite(const gl::Device& device);

// Whether a shader's arithmetic keeps numbers below 2^-126.
bool keepsDenormals(const gl::Device& device);

}  // namespace glimt
