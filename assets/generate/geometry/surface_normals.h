// Smooth shading, with sharp edges where a surface has them.
#pragma once

#include "assets/generate/geometry/mesh.h"

namespace glimt::assets {

struct ShadedMesh {
  std::vector<dvec3> positions;
  std::vector<dvec3> normals;
  std::vector<dvec2> texture_coordinates;  // none, or one for each position
  std::vector<uvec3> triangles;
};

// Each corner's normal is the mean of the faces around it, by their angle there, that are turned
// less than `crease` degrees from its own. Points in the same place belong together.
ShadedMesh shaded(const Mesh& mesh, double crease);

}  // namespace glimt::assets
