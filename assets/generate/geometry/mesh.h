// Triangles as they are modelled: places alone. Normals come last, in surface_normals.h.
#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <vector>

namespace glimt::assets {

using glm::dmat4;
using glm::dvec2;
using glm::dvec3;
using glm::uvec3;

// Metres, +y up; triangles are counter-clockwise seen from outside.
struct Mesh {
  std::vector<dvec3> positions;
  std::vector<dvec2> texture_coordinates;  // none, or one for each position
  std::vector<uvec3> triangles;
};

// Adds `more` to `mesh`. Both have texture coordinates, or neither has, or `mesh` is empty.
void append(Mesh& mesh, const Mesh& more);

// All of them in one.
Mesh joined(const std::vector<Mesh>& meshes);

// Moved by an affine map; one that mirrors turns the triangles over, so that outside stays outside.
Mesh transformed(Mesh mesh, const dmat4& map);

dmat4 moved(const dvec3& by);
dmat4 turned(double degrees, const dvec3& axis);
dmat4 scaled(const dvec3& by);

// Carries +y to `direction` and the origin to `at`: what is made upright points there.
dmat4 pointing(const dvec3& at, const dvec3& direction);

// The mesh and its mirror image across the plane z = 0.
Mesh withMirrorImage(const Mesh& mesh);

// `count` copies, turned evenly about an axis through the origin.
Mesh aroundAxis(const Mesh& mesh, int count, const dvec3& axis);

}  // namespace glimt::assets
