// The surface area heuristic, for the ways to find a split.
#pragma once

#include <algorithm>
#include <limits>

#include "renderer/bvh/split.h"

namespace glimt {

struct SplitSide {
  Box4 bounds;
  std::uint32_t count = 0;

  void include(const Box4& box, std::uint32_t primitives) {
    bounds.include(box);
    count += primitives;
  }
};

// Times the parent's area, and without what its two children cost as nodes. Among equals the more
// balanced one is less: where all areas are zero, or infinite, a tree is to remain.
struct SplitCost {
  float sum = std::numeric_limits<float>::infinity();
  std::uint32_t larger_side = std::numeric_limits<std::uint32_t>::max();

  SplitCost() = default;
  SplitCost(const SplitSide& lower, const SplitSide& upper)
      : sum(lower.bounds.halfArea() * static_cast<float>(lower.count) +
            upper.bounds.halfArea() * static_cast<float>(upper.count)),
        larger_side(std::max(lower.count, upper.count)) {}

  bool operator<(const SplitCost& other) const {
    return sum < other.sum || (sum == other.sum && larger_side < other.larger_side);
  }
};

// So few are sorted along each axis, which is faster than bins and finds the best split of all.
inline constexpr std::uint32_t kMostSwept = 16;

SplitRange splitSwept(BvhPrimitives& primitives, const PrimitiveRange& range);

}  // namespace glimt
