// Which of a triangle's corners is vertex 0 on the device.
#pragma once

#include <array>
#include <cstddef>

#include "renderer/scene/scene.h"

namespace glimt {

// A triangle's plane is calculated from the two edges at vertex 0. Of a sliver they have to be the
// short one and a long one: the cross product of two long ones that are nearly parallel loses the
// plane, and rays that leave the sliver would have to start far from it; see errorScale() in
// shaders/ray_origin.glsl. So vertex 0 of a sliver is the corner across from its longest edge, and
// the others follow in their order. Other triangles keep theirs.
std::array<std::size_t, 3> cornerOrder(const Scene& scene, const Triangle& triangle);

}  // namespace glimt
