#pragma once

#include "renderer/scene/scene.h"

namespace glimt {

// Coordinates farther out, in metres, are dropped: the squared area of a triangle between them
// still is a float.
inline constexpr float kLargestCoordinate = 1e8f;

// Makes a scene safe to render, whatever it was read from. Drops triangles with indices out of
// range, with vertices that are not finite or too far out, and without an area; gives normals unit
// length, and makes triangles flat that have none to use; clamps materials; removes vertices and
// normals that no triangle uses. Every kind of change is told in scene.warnings, once.
void checkScene(Scene& scene);

}  // namespace glimt
