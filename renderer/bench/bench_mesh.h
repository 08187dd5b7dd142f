// Scenes that need no file.
#pragma once

#include <cstddef>

#include "renderer/scene/scene.h"

namespace glimt {

// The light of every scene: a square around the y axis that faces down.
inline constexpr float kLightHalfSide = 1;
inline constexpr float kLightHeight = 3.99f;

// A tube along the (2,3) torus knot with a rippled surface, in a room that is open towards the
// camera. It has about as many triangles as asked for, nearly all in the tube.
Scene makeBenchMesh(std::size_t triangles);

// Two blocks in a closed room with a red and a green wall: paths end at the bounce limit only.
Scene makeBenchBox();

}  // namespace glimt
