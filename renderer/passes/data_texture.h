// Arrays of texels as textures of power-of-two sizes; read with shaders/texel_address.glsl.
#pragma once

#include <string>
#include <vector>

#include "renderer/gl/device.h"

namespace glimt {

// How many texels fit into a data texture on a device with textures of up to `max_texture_size` a
// side.
std::size_t mostTexels(int max_texture_size);

// `what` names the data for the message. Errors: input, when it is more than fits.
gl::Texture makeDataTexture(const gl::Device& device, std::vector<Vec4> texels,
                            const std::string& what);

}  // namespace glimt
