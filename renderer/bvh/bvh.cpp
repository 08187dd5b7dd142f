#include "renderer/bvh/bvh.h"

#include <algorithm>
#include <array>
#include <numeric>

namespace glimt {
namespace {

constexpr int kBins = 32;

// What a step into a node costs, in units of one triangle: it reads one texel where a triangle
// reads three, and calculates less.
constexpr float kNodeCost = 0.6f;

struct Bin {
  Bounds bounds;
  int count = 0;
};

struct Split {
  float cost = std::numeric_limits<float>::infinity();
  int axis = 0;
  int bin = 0;  // the first bin of the upper side
};

// Puts centroids into bins along one axis.
struct Binning {
  float start = 0;
  float scale = 0;

  Binning(const Bounds& centroids, int axis)
      : start(centroids.min[axis]), scale(kBins / centroids.size()[axis]) {}
  int operator()(float centroid) const {
    return std::clamp(static_cast<int>((centroid - start) * scale), 0, kBins - 1);
  }
};

struct Range {
  std::uint32_t begin;
  std::uint32_t end;

  std::uint32_t size() const { return end - begin; }
};

class Builder {
 public:
  explicit Builder(const std::vector<Bounds>& boxes) : boxes_(boxes) {
    bvh_.order.resize(boxes.size());
    std::iota(bvh_.order.begin(), bvh_.order.end(), 0u);
    centroids_.reserve(boxes.size());
    for (const Bounds& box : boxes) centroids_.push_back(box.center());
  }

  Bvh build() {
    if (boxes_.empty()) return {};
    struct Task {
      std::uint32_t node;
      Range range;
    };
    bvh_.nodes.emplace_back();
    std::vector<Task> tasks{{0, {0, static_cast<std::uint32_t>(boxes_.size())}}};
    while (!tasks.empty()) {
      const auto [node, range] = tasks.back();
      tasks.pop_back();
      const std::uint32_t middle = makeNode(node, range);
      if (bvh_.nodes[node].leaf()) continue;
      const std::uint32_t lower = bvh_.nodes[node].first;
      tasks.push_back({lower + 1, {middle, range.end}});
      tasks.push_back({lower, {range.begin, middle}});
    }
    return std::move(bvh_);
  }

 private:
  // Returns where the range is divided, if the node is an inner one.
  std::uint32_t makeNode(std::uint32_t index, Range range) {
    Bounds bounds;
    Bounds centroids;
    for (std::uint32_t i = range.begin; i < range.end; ++i) {
      bounds.include(boxes_[bvh_.order[i]]);
      centroids.include(centroids_[bvh_.order[i]]);
    }
    const Split split = bestSplit(range, bounds, centroids);
    const auto size = static_cast<float>(range.size());
    if (range.size() <= kMaxLeafSize && split.cost >= size) {
      bvh_.nodes[index] = {bounds, range.begin, static_cast<std::uint16_t>(range.size()), 0};
      return range.begin;
    }
    const auto lower = static_cast<std::uint32_t>(bvh_.nodes.size());
    bvh_.nodes[index] = {bounds, lower, 0, static_cast<std::uint8_t>(split.axis)};
    bvh_.nodes.resize(bvh_.nodes.size() + 2);
    return divide(range, split, centroids);
  }

  Split bestSplit(Range range, const Bounds& bounds, const Bounds& centroids) const {
    Split best;
    for (int axis = 0; axis < 3; ++axis) {
      if (!(centroids.size()[axis] > 0)) continue;
      std::array<Bin, kBins> bins;
      const Binning binOf(centroids, axis);
      for (std::uint32_t i = range.begin; i < range.end; ++i) {
        const std::uint32_t primitive = bvh_.order[i];
        Bin& bin = bins[static_cast<std::size_t>(binOf(centroids_[primitive][axis]))];
        bin.bounds.include(boxes_[primitive]);
        ++bin.count;
      }
      sweep(bins, axis, bounds.halfArea(), best);
    }
    return best;
  }

  // Costs of all splits between bins: from above first, then from below.
  static void sweep(const std::array<Bin, kBins>& bins, int axis, float area, Split& best) {
    std::array<float, kBins> upper{};
    Bounds bounds;
    int count = 0;
    for (int i = kBins - 1; i > 0; --i) {
      bounds.include(bins[static_cast<std::size_t>(i)].bounds);
      count += bins[static_cast<std::size_t>(i)].count;
      upper[static_cast<std::size_t>(i)] = bounds.halfArea() * static_cast<float>(count);
    }
    bounds = {};
    count = 0;
    for (int i = 1; i < kBins; ++i) {
      bounds.include(bins[static_cast<std::size_t>(i - 1)].bounds);
      count += bins[static_cast<std::size_t>(i - 1)].count;
      const float lower = bounds.halfArea() * static_cast<float>(count);
      const float cost = 2 * kNodeCost + (lower + upper[static_cast<std::size_t>(i)]) / area;
      if (cost < best.cost) best = {cost, axis, i};
    }
  }

  std::uint32_t divide(Range range, const Split& split, const Bounds& centroids) {
    const auto begin = bvh_.order.begin() + range.begin;
    const auto end = bvh_.order.begin() + range.end;
    auto middle = begin;
    if (split.cost < std::numeric_limits<float>::infinity()) {
      const Binning binOf(centroids, split.axis);
      middle = std::partition(begin, end, [&](std::uint32_t primitive) {
        return binOf(centroids_[primitive][split.axis]) < split.bin;
      });
    }
    // All centroids in one place, or all in one bin: any halves are as good as any others.
    if (middle == begin || middle == end) middle = begin + range.size() / 2;
    return static_cast<std::uint32_t>(middle - bvh_.order.begin());
  }

  const std::vector<Bounds>& boxes_;
  std::vector<Vec3> centroids_;
  Bvh bvh_;
};

}  // namespace

Bvh buildBvh(const std::vector<Bounds>& boxes) {
  return Builder(boxes).build();
}

}  // namespace glimt
