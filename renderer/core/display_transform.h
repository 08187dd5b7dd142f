// From linear radiance to what a display is sent, on the CPU.
#pragma once

#include "renderer/core/image.h"

namespace glimt {

// radiance * 2^exposure, clipped at 1, sRGB-encoded: what shaders/display_transform.glsl does.
DisplayImage displayImage(const Image& radiance, float exposure);

}  // namespace glimt
