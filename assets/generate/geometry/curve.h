// Lines in space, and what is swept along them: tubes, cables, belts.
#pragma once

#include <functional>

#include "assets/generate/geometry/mesh.h"

namespace glimt::assets {

using Path = std::vector<dvec3>;

// Through all controls (Catmull-Rom), `steps` pieces from each to the next.
Path smoothPath(const Path& controls, int steps);

// Straight pieces with corners rounded to `radius`, as tubes are bent; `steps` pieces per corner.
Path bentPath(const Path& controls, double radius, int steps);

// `steps` pieces of a circle in the plane of two directions that stand upright on each other.
Path arcPath(const dvec3& center, const dvec3& x, const dvec3& y, double from_degrees,
             double to_degrees, int steps);

// A closed section (x to the side, y along `up` at the start) moved along an open path without
// twisting; scale(t) sizes it at t in [0, 1] of the path's points.
Mesh sweep(const Path& path, const std::vector<dvec2>& section, const dvec3& up,
           const std::function<double(double)>& scale, bool capped);

// A round tube with closed ends.
Mesh tube(const Path& path, double radius, int sides);

// A round tube along a path that ends where it begins (the first point is not repeated).
Mesh closedTube(const Path& path, double radius, int sides);

// A helix of wire about +y, from y = 0 to `height`.
Mesh coilSpring(double radius, double wire, double height, double turns, int steps_per_turn);

std::vector<dvec2> circle(double radius, int sides);

// |x / a|^n + |y / b|^n = 1: an ellipse at 2, the squarer the larger.
std::vector<dvec2> superellipse(double a, double b, double exponent, int sides);

}  // namespace glimt::assets
