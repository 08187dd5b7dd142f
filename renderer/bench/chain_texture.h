// A texture whose texels lead from one to the next, through all of them in random order.
#pragma once

#include <cstddef>

#include "renderer/gl/device.h"

namespace glimt {

// A power of two of bytes, at least one texel. Each texel holds the middle of the next one as a
// texture coordinate, twice. Errors: input, where it is larger than the device's textures.
gl::Texture makeChainTexture(const gl::Device& device, std::size_t bytes);

}  // namespace glimt
