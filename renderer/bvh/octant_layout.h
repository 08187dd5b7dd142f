// The tree as the traversal by ray octants reads it; see shaders/traverse_octant.glsl.
#pragma once

#include <vector>

#include "renderer/bvh/bvh.h"

namespace glimt {

struct OctantLayout {
  std::vector<Vec4> texels;          // eight copies, laid out as shaders/layout.h says
  std::size_t nodes_per_octant = 0;  // with the one at the end of each copy
  Vec3 grid_origin{0};
  Vec3 grid_cell{1};  // metres
};

// A leaf's triangles are those at its place in Bvh::order.
OctantLayout layOutOctants(const Bvh& bvh);

}  // namespace glimt
