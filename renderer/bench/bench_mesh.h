// A mesh of any size that needs no file.
#pragma once

#include <cstddef>

#include "renderer/scene/scene.h"

namespace glimt {

// The light of every mesh: a square around the y axis that faces down.
inline constexpr float kLightHalfSide = 1;
inline constexpr float kLightHeight = 3.99f;

// A tube along the (2,3) torus knot with a rippled surface, in a room that is open towards the
// camera. It has about as many triangles as asked for, nearly all in the tube.
Scene makeBenchMesh(std::size_t triangles);

}  // namespace glimt
