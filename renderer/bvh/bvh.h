// A bounding volume hierarchy over boxes.
#pragma once

#include <cstdint>
#include <vector>

#include "renderer/core/bounds.h"
#include "renderer/core/work_progress.h"

namespace glimt {

struct BvhNode {
  Bounds bounds;
  std::uint32_t first =
      0;  // inner: index of the lower child, the upper one follows it; leaf: into order
  std::uint16_t count = 0;  // of primitives; 0 for an inner node
  std::uint8_t axis = 0;    // inner: 0, 1 or 2, along which the lower child comes first

  bool leaf() const { return count > 0; }
};

// Node 0 is the root. Without primitives there are no nodes.
struct Bvh {
  std::vector<BvhNode> nodes;
  std::vector<std::uint32_t> order;  // primitives, those of a leaf side by side
};

inline constexpr int kMaxLeafSize = 4;

// Top down, each split chosen by the surface area heuristic over bins of centroids: Wald 2007, "On
// fast Construction of SAH-based Bounding Volume Hierarchies". Where primitives are not too many,
// reinsertion improves the tree. It depends on the boxes alone, not on the number of threads: 0 for
// as many as the machine has, 1 for no other than the calling one.
Bvh buildBvh(const std::vector<Bounds>& boxes, unsigned threads = 0,
             const WorkProgress& progress = {});

}  // namespace glimt
