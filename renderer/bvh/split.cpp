#include "renderer/bvh/split.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "renderer/bvh/bvh.h"
#include "renderer/bvh/split_cost.h"

namespace glimt {
namespace {

constexpr std::uint32_t kMostBins = 32;
constexpr std::uint32_t kFewBins = 16;
constexpr std::uint32_t kFewPrimitives = 512;  // up to here few bins: going over them would prevail

// Puts centroids into bins along each axis.
class Binning {
 public:
  Binning(const Box4& centroids, std::uint32_t bins)
      : start_(centroids.min), last_(Float4{} + static_cast<float>(bins - 1)) {
    const Float4 size = centroids.max - centroids.min;
    for (int axis = 0; axis < 3; ++axis) {
      // Not finite for a size of zero or next to it, and zero if the size is infinite.
      const float scale = static_cast<float>(bins) / size[axis];
      if (std::isfinite(scale)) scale_[axis] = scale;
    }
  }

  bool divides(int axis) const { return scale_[axis] > 0; }
  // The bin on each axis. Not a number, where the bounds are so far apart that their distance is
  // infinite, becomes the last.
  Float4 places(Float4 centroid) const {
    const Float4 place = (centroid - start_) * scale_;
    return place < last_ ? place : last_;
  }

 private:
  Float4 start_;
  Float4 scale_{};
  Float4 last_;
};

struct Bins {
  std::array<std::array<Box4, kMostBins>, 3> boxes;
  std::array<std::array<std::uint32_t, kMostBins>, 3> counts{};

  Bins(const BvhPrimitives& primitives, const PrimitiveRange& range, const Binning& binning) {
    for (std::uint32_t i = range.begin; i < range.end; ++i) {
      const Box4& box = primitives.boxes[i];
      const Float4 places = binning.places(box.center());
      for (int axis = 0; axis < 3; ++axis) {
        const std::size_t bin = static_cast<std::size_t>(places[axis]);
        boxes[static_cast<std::size_t>(axis)][bin].include(box);
        ++counts[static_cast<std::size_t>(axis)][bin];
      }
    }
  }
};

struct BinnedSplit {
  SplitCost cost;
  int axis = 0;
  std::size_t bin = 0;  // the first bin of the upper side; 0 if no axis divides the range
};

// Costs of all splits between bins: from above first, then from below.
void sweep(const Bins& bins, std::size_t axis, std::size_t bin_count, BinnedSplit& best) {
  const auto& boxes = bins.boxes[axis];
  const auto& counts = bins.counts[axis];
  std::array<SplitSide, kMostBins> upper;
  SplitSide side;
  for (std::size_t i = bin_count - 1; i > 0; --i) {
    side.include(boxes[i], counts[i]);
    upper[i] = side;
  }
  side = {};
  for (std::size_t i = 1; i < bin_count; ++i) {
    side.include(boxes[i - 1], counts[i - 1]);
    if (counts[i - 1] == 0 || side.count == 0 || upper[i].count == 0) continue;
    const SplitCost cost(side, upper[i]);
    if (cost < best.cost) best = {cost, static_cast<int>(axis), i};
  }
}

// The centroids' bounds of both sides come with it.
SplitRange divide(BvhPrimitives& primitives, const PrimitiveRange& range, const Binning& binning,
                  const BinnedSplit& best) {
  SplitRange result{false, best.axis, {}, {}};
  std::uint32_t middle = range.begin;
  std::uint32_t end = range.end;
  while (middle < end) {
    const Box4 box = primitives.boxes[middle];
    const auto bin = static_cast<std::size_t>(binning.places(box.center())[best.axis]);
    if (bin < best.bin) {
      result.lower.include(box);
      ++middle;
    } else {
      result.upper.include(box);
      primitives.swap(middle, --end);
    }
  }
  result.lower.begin = range.begin;
  result.lower.end = result.upper.begin = middle;
  result.upper.end = range.end;
  return result;
}

// All centroids in one place: any halves are as good as any others.
SplitRange halve(const BvhPrimitives& primitives, const PrimitiveRange& range) {
  SplitRange result;
  const std::uint32_t middle = range.begin + range.size() / 2;
  result.lower.begin = range.begin;
  result.lower.end = result.upper.begin = middle;
  result.upper.end = range.end;
  for (std::uint32_t i = range.begin; i < middle; ++i) result.lower.include(primitives.boxes[i]);
  for (std::uint32_t i = middle; i < range.end; ++i) result.upper.include(primitives.boxes[i]);
  return result;
}

SplitRange splitBinned(BvhPrimitives& primitives, const PrimitiveRange& range) {
  const std::uint32_t bin_count = range.size() <= kFewPrimitives ? kFewBins : kMostBins;
  const Binning binning(range.centroids, bin_count);
  const Bins bins(primitives, range, binning);
  BinnedSplit best;
  for (int axis = 0; axis < 3; ++axis)
    if (binning.divides(axis)) sweep(bins, static_cast<std::size_t>(axis), bin_count, best);
  if (best.bin == 0) return halve(primitives, range);
  return divide(primitives, range, binning, best);
}

}  // namespace

SplitRange split(BvhPrimitives& primitives, const PrimitiveRange& range) {
  if (range.size() <= kMostSwept) return splitSwept(primitives, range);
  return splitBinned(primitives, range);
}

}  // namespace glimt
