#pragma once

#include "app/json_output.h"
#include "renderer/renderer.h"

namespace glimt {

// All that decides which samples a picture is made of, the camera's place among it; not how many,
// nor how they are shown. Two devices' samples differ in their last bits.
Json inputsOf(const Scene& scene, const RenderSettings& settings);

}  // namespace glimt
