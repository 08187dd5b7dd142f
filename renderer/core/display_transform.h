// From linear radiance to what a display is sent, on the CPU.
#pragma once

#include "renderer/core/image.h"
#include "renderer/core/tone.h"

namespace glimt {

// radiance * 2^exposure, by the tone's curve brought into 0 to 1, sRGB-encoded: what
// shaders/display_transform.glsl and the files of the tones do.
DisplayImage displayImage(const Image& radiance, float exposure, Tone tone = Tone::srgb);

}  // namespace glimt
