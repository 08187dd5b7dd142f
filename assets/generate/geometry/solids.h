// What is turned, cut or moulded: lathe work, boxes with rounded edges, plates, balls.
#pragma once

#include "assets/generate/geometry/mesh.h"

namespace glimt::assets {

// A profile (radius, height) turned about +y. From bottom to top it is seen from outside; a
// profile that ends at radius 0 closes the surface.
Mesh lathe(const std::vector<dvec2>& profile, int segments);

// A solid between two heights, with edges rounded by `bevel`.
Mesh cylinder(double radius, double bottom, double top, double bevel, int segments);

// A tube's piece: inner and outer radius, edges rounded by `bevel`.
Mesh ring(double inner, double outer, double bottom, double top, double bevel, int segments);

// About +y: the radius of the middle line, and that of the tube.
Mesh torus(double radius, double tube, int segments, int sides);

Mesh sphere(double radius, int segments);

// Centred at the origin; `segments` over each rounded edge. A radius of half the size is a ball.
Mesh roundedBox(const dvec3& size, double radius, int segments);

// A plate: a counter-clockwise outline in x, y, from z = 0 to `depth`, with bevelled edges. The
// outline is star-shaped as seen from its middle.
Mesh plate(const std::vector<dvec2>& outline, double depth, double bevel);

// A cover: the same, with the edge of its far side rounded in `steps`.
Mesh cover(const std::vector<dvec2>& outline, double depth, double radius, int steps);

// The outline of two circles with a belt round them.
std::vector<dvec2> beltOutline(const dvec2& a, double radius_a, const dvec2& b, double radius_b,
                               int steps);

// A screw's head, hexagonal, standing on y = 0; `size` across its corners.
Mesh boltHead(double size);

}  // namespace glimt::assets
