// Polygons into triangles.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "renderer/core/vector.h"

namespace glimt {

// Corner numbers (0 to points.size() - 1) of points.size() - 2 triangles that are wound like the
// polygon and, if it is flat and does not cross itself, cover it exactly. Nothing that a polygon
// may be (bent, crossed, a line, not finite) is an error; its triangles are then some way to span
// the corners. Takes time linear in the corners when it is convex.
std::vector<std::array<std::uint32_t, 3>> triangulate(const std::vector<Vec3>& points);

}  // namespace glimt
