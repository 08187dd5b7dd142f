// How light samples are divided among the kinds of light.
#pragma once

#include "renderer/core/vector.h"
#include "renderer/passes/light_table.h"

namespace glimt {

// Shares of the environment, of triangles that emit and of lights without triangles; they sum to 1
// where there is any light. Where lights are nearby, an environment with a picture gets half: which
// of them matters differs from point to point, and half is never off by more than a factor of two.
// An even one gets between a sixteenth and a half, the more the brighter it is beside the lights.
// Triangles and lights without them share the rest in proportion to their power, but neither gets
// less than a quarter of it.
Vec3 lightShares(const Scene& scene, const LightTable& triangles);

}  // namespace glimt
