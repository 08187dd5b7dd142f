// Where a node's primitives are divided among its two children.
#pragma once

#include <cstdint>
#include <vector>

#include "renderer/bvh/box4.h"

namespace glimt {

// What a step into a node costs, in units of one triangle: it reads one texel where a triangle
// reads three, and calculates less.
inline constexpr float kNodeCost = 0.6f;

// Boxes lie in the order of the tree as well, as far as it is known: reading them by index would
// miss the cache at each.
struct BvhPrimitives {
  std::vector<Box4> boxes;
  std::vector<std::uint32_t> order;

  void swap(std::uint32_t a, std::uint32_t b) {
    std::swap(boxes[a], boxes[b]);
    std::swap(order[a], order[b]);
  }
};

struct PrimitiveRange {
  std::uint32_t begin = 0;
  std::uint32_t end = 0;
  Box4 bounds;
  Box4 centroids;

  std::uint32_t size() const { return end - begin; }
  void include(const Box4& box) {
    bounds.include(box);
    centroids.include(box.center());
  }
};

struct SplitRange {
  bool leaf = false;  // cheaper undivided, and few enough; then the rest means nothing
  int axis = 0;
  PrimitiveRange lower;
  PrimitiveRange upper;
};

// By the surface area heuristic: over bins of centroids, or where primitives are few over all
// places between them. Neither child is empty. The range has two primitives or more, or becomes a
// leaf. Touches nothing outside the range.
SplitRange split(BvhPrimitives& primitives, const PrimitiveRange& range);

}  // namespace glimt
