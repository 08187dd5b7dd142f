// Lights without triangles, as shaders/punctual_lights.glsl reads them.
#pragma once

#include <vector>

#include "renderer/scene/scene.h"

namespace glimt {

// Of all of them, in watts in the sense of Scene's radiances: what they shine into the scene, of a
// directional light what passes a disk as large as the scene.
double powerOfPunctualLights(const Scene& scene);

// Laid out as shaders/layout.h says, lights that shine only. Most samples go to them in proportion
// to their power; a fifth is dealt out evenly, for places where only a weak light arrives.
std::vector<Vec4> packPunctualLights(const Scene& scene);

}  // namespace glimt
