// How light samples are divided among the kinds of light.
#pragma once

#include "renderer/core/vector.h"
#include "renderer/passes/light_table.h"

namespace glimt {

// Of the environment, of triangles that emit and of lights without triangles; they sum to 1 where
// there is any light.
struct LightShares {
  Vec3 usual{0};
  Vec3 alone{0};  // where no ray will come upon the light by chance
};

// Where lights are nearby, an environment with a picture gets half: which of them matters differs
// from point to point, and half is never off by more than a factor of two. An even one gets the
// more the brighter it is beside the lights: usually between a sixteenth and a half, alone between
// a quarter and three quarters. Triangles and lights without them share the rest in proportion to
// their power, but neither gets less than a quarter of it.
LightShares lightShares(const Scene& scene, const LightTable& triangles);

}  // namespace glimt
