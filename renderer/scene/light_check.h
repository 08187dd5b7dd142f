// What makes lights without triangles safe to render.
#pragma once

#include "renderer/scene/scene.h"

namespace glimt {

// Drops lights whose place, direction or intensity is not finite, or too far away, with a warning.
// Directions get unit length; ranges and cones are brought into what they may be.
void checkLights(Scene& scene);

}  // namespace glimt
