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
//
// `effort` bounds the time for what is not convex, and what is used of it is taken off: once it is
// zero, corners are cut off without looking for what lies in the way.
std::vector<std::array<std::uint32_t, 3>> triangulate(const std::vector<Vec3>& points,
                                                      std::int64_t& effort);

// More than enough for one polygon, and for all those of a file together; seconds at most.
inline constexpr std::int64_t kEffortForPolygon = 4'000'000;
inline constexpr std::int64_t kEffortForFile = 400'000'000;

}  // namespace glimt
