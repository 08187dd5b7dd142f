// The tree as the traversals read it: shaders/layout.h says how nodes are laid out.
#pragma once

#include <vector>

#include "renderer/bvh/bvh.h"

namespace glimt {

struct NodeLayout {
  std::vector<Vec4> texels;
  std::size_t nodes_per_copy = 0;  // with the one at the end, where there is one
  Vec3 grid_origin{0};
  Vec3 grid_cell{1};  // metres
};

// In all of them a leaf's triangles are those at its place in Bvh::order.

// Depth first, once for each ray octant.
NodeLayout layOutOctants(const Bvh& bvh);

// Depth first, once: corners in no order, and the lower child always in front.
NodeLayout layOutOnce(const Bvh& bvh);

// Children side by side.
NodeLayout layOutPairs(const Bvh& bvh);

// Children side by side, with the way up between them.
NodeLayout layOutTriples(const Bvh& bvh);

// How many entries the stack of a traversal has to hold at most: one for each inner node on the way
// to a leaf, and the end.
std::size_t stackSizeOf(const Bvh& bvh);

}  // namespace glimt
