#include <array>
#include <numeric>

#include "renderer/bvh/bvh.h"
#include "renderer/bvh/split_cost.h"

namespace glimt {
namespace {

using Permutation = std::array<std::uint8_t, kMostSwept>;

// A copy of a few primitives, to reorder them.
struct Few {
  std::array<Box4, kMostSwept> boxes;
  std::array<Vec3, kMostSwept> centroids;
  std::array<std::uint32_t, kMostSwept> order;
  std::size_t size;

  Few(const BvhPrimitives& primitives, const PrimitiveRange& range) : size(range.size()) {
    for (std::size_t i = 0; i < size; ++i) {
      boxes[i] = primitives.boxes[range.begin + i];
      const Float4 center = boxes[i].center();
      centroids[i] = {center[0], center[1], center[2]};
      order[i] = primitives.order[range.begin + i];
    }
  }
};

struct SweptSplit {
  SplitCost cost;
  int axis = 0;
  std::size_t lower_size = 0;
  Permutation sorted{};
};

// By insertion: so few are sorted fastest like that, and equal ones keep their order.
void sortAlong(int axis, const Few& few, Permutation& sorted) {
  for (std::size_t i = 1; i < few.size; ++i) {
    const std::uint8_t moved = sorted[i];
    const float key = few.centroids[moved][axis];
    std::size_t to = i;
    for (; to > 0 && few.centroids[sorted[to - 1]][axis] > key; --to) sorted[to] = sorted[to - 1];
    sorted[to] = moved;
  }
}

void sweep(const Few& few, int axis, const Permutation& sorted, SweptSplit& best) {
  std::array<SplitSide, kMostSwept> upper;
  SplitSide side;
  for (std::size_t i = few.size - 1; i > 0; --i) {
    side.include(few.boxes[sorted[i]], 1);
    upper[i] = side;
  }
  side = {};
  for (std::size_t i = 1; i < few.size; ++i) {
    side.include(few.boxes[sorted[i - 1]], 1);
    const SplitCost cost(side, upper[i]);
    if (cost < best.cost) best = {cost, axis, i, sorted};
  }
}

bool cheaperAsLeaf(const PrimitiveRange& range, const SweptSplit& best) {
  if (range.size() > kMaxLeafSize) return false;
  const float area = range.bounds.halfArea();
  return best.cost.sum + 2 * kNodeCost * area >= static_cast<float>(range.size()) * area;
}

SplitRange divide(BvhPrimitives& primitives, const PrimitiveRange& range, const Few& few,
                  const SweptSplit& best) {
  SplitRange result{false, best.axis, {}, {}};
  for (std::size_t i = 0; i < few.size; ++i) {
    const std::size_t from = best.sorted[i];
    primitives.boxes[range.begin + i] = few.boxes[from];
    primitives.order[range.begin + i] = few.order[from];
    (i < best.lower_size ? result.lower : result.upper).include(few.boxes[from]);
  }
  result.lower.begin = range.begin;
  result.lower.end = result.upper.begin = range.begin + static_cast<std::uint32_t>(best.lower_size);
  result.upper.end = range.end;
  return result;
}

}  // namespace

SplitRange splitSwept(BvhPrimitives& primitives, const PrimitiveRange& range) {
  SplitRange leaf{true, 0, {}, {}};
  if (range.size() < 2) return leaf;
  const Few few(primitives, range);
  Permutation sorted;
  std::iota(sorted.begin(), sorted.end(), std::uint8_t{0});
  SweptSplit best{{}, 0, few.size / 2, sorted};  // what is left if no cost is a number
  for (int axis = 0; axis < 3; ++axis) {
    sortAlong(axis, few, sorted);
    sweep(few, axis, sorted, best);
  }
  if (cheaperAsLeaf(range, best)) return leaf;
  return divide(primitives, range, few, best);
}

}  // namespace glimt
