// Whether element i of a data texture is found (shaders/texel_address.glsl).
#pragma once

#include <cstddef>

#include "renderer/gl/device.h"

namespace glimt {

struct AddressProbe {
  std::size_t elements = 0;  // asked for
  std::size_t wrong = 0;     // of them: another one was found, or this one near its texel's border
};

// Of a texture of `size` elements, all or a million of them. Errors: input, for more than fit.
AddressProbe probeAddresses(const gl::Device& device, std::size_t size);

}  // namespace glimt
