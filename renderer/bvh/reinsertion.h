// Makes a tree cheaper by moving subtrees to better places: Bittner, Hapala, Havran 2013, "Fast
// Insertion-Based Optimization of Bounding Volume Hierarchies", with the search from Meister and
// Bittner 2018, "Parallel Reinsertion for Bounding Volume Hierarchy Optimization".
#pragma once

#include <vector>

#include "renderer/bvh/bvh.h"

namespace glimt {

// Leaves stay as they are. Nodes come out depth first, and each lower child is the first of the two
// along the axis on which the children's centres differ most.
void reinsertNodes(std::vector<BvhNode>& nodes, const WorkProgress& progress = {});

}  // namespace glimt
