#include "renderer/bvh/bvh.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <numeric>
#include <thread>

#include "renderer/bvh/node_layout.h"
#include "renderer/bvh/parallel_for.h"
#include "renderer/bvh/reinsertion.h"
#include "renderer/bvh/split.h"
#include "shaders/layout.h"

namespace glimt {
namespace {

// Larger ranges are divided level by level, those of a level in parallel; then the subtrees below
// are built in parallel. Must not depend on the number of threads, since the order of nodes does
// on this.
constexpr std::uint32_t kSubtreeSize = 1u << 14;

// On larger trees reinsertion takes long on its one thread, and gains little.
constexpr std::size_t kMostReinserted = 200000;

// For telling progress: so many levels take about as long as the subtrees that follow them, and
// where there is reinsertion, it takes the rest from this share on.
constexpr float kSubtreeLevels = 12;
constexpr float kReinsertionBegins = 0.6f;

struct Task {
  std::uint32_t node;
  PrimitiveRange range;
};

BvhNode nodeOf(const PrimitiveRange& range, const SplitRange& split, std::size_t children) {
  if (split.leaf)
    return {range.bounds.bounds(), range.begin, static_cast<std::uint16_t>(range.size()), 0};
  return {range.bounds.bounds(), static_cast<std::uint32_t>(children), 0,
          static_cast<std::uint8_t>(split.axis)};
}

// Its root is node 0.
std::vector<BvhNode> buildSubtree(BvhPrimitives& primitives, const PrimitiveRange& whole) {
  std::vector<BvhNode> nodes(1);
  nodes.reserve(whole.size());
  std::vector<Task> tasks{{0, whole}};
  while (!tasks.empty()) {
    const Task task = tasks.back();
    tasks.pop_back();
    const SplitRange halves = split(primitives, task.range);
    nodes[task.node] = nodeOf(task.range, halves, nodes.size());
    if (halves.leaf) continue;
    const std::uint32_t lower = nodes[task.node].first;
    nodes.resize(nodes.size() + 2);
    tasks.push_back({lower + 1, halves.upper});
    tasks.push_back({lower, halves.lower});
  }
  return nodes;
}

class Builder {
 public:
  Builder(const std::vector<Bounds>& boxes, unsigned threads, const WorkProgress& progress)
      : threads_(threads), progress_(progress) {
    primitives_.boxes.reserve(boxes.size());
    for (const Bounds& box : boxes) primitives_.boxes.emplace_back(box);
    primitives_.order.resize(boxes.size());
    std::iota(primitives_.order.begin(), primitives_.order.end(), 0u);
  }

  Bvh build() {
    if (primitives_.boxes.empty()) return {};
    nodes_.emplace_back();
    std::vector<Task> level{{0, all()}};
    while (!level.empty()) level = buildLevel(takeSubtrees(std::move(level)));
    buildSubtrees(partOf(progress_, levelsDone(), 1));
    return {std::move(nodes_), std::move(primitives_.order)};
  }

 private:
  PrimitiveRange all() const {
    PrimitiveRange range;
    range.end = static_cast<std::uint32_t>(primitives_.boxes.size());
    for (const Box4& box : primitives_.boxes) range.include(box);
    return range;
  }

  // The share of the work, where levels are as many as in a balanced tree.
  float levelsDone() const {
    const float levels = divided_ / static_cast<float>(primitives_.boxes.size());
    const float balanced = std::log2(static_cast<float>(primitives_.boxes.size()) / kSubtreeSize);
    return levels / (std::max(levels, balanced) + kSubtreeLevels);
  }

  // Returns those that are too large for one.
  std::vector<Task> takeSubtrees(std::vector<Task> level) {
    const auto small = std::stable_partition(level.begin(), level.end(), [](const Task& task) {
      return task.range.size() > kSubtreeSize;
    });
    subtrees_.insert(subtrees_.end(), small, level.end());
    level.erase(small, level.end());
    return level;
  }

  // Returns the next level.
  std::vector<Task> buildLevel(const std::vector<Task>& level) {
    std::vector<SplitRange> splits(level.size());
    parallelFor(threads_, level.size(),
                [&](std::size_t i) { splits[i] = split(primitives_, level[i].range); });
    std::vector<Task> next;
    for (std::size_t i = 0; i < level.size(); ++i) {
      const auto lower = static_cast<std::uint32_t>(nodes_.size());
      nodes_[level[i].node] = nodeOf(level[i].range, splits[i], lower);
      nodes_.resize(nodes_.size() + 2);
      next.push_back({lower, splits[i].lower});
      next.push_back({lower + 1, splits[i].upper});
      divided_ += static_cast<float>(level[i].range.size());
    }
    if (progress_) progress_(levelsDone());
    return next;
  }

  // The calling thread takes subtrees like the others, and tells after each of its own what all
  // have done.
  void buildSubtrees(const WorkProgress& progress) {
    std::vector<std::vector<BvhNode>> built(subtrees_.size());
    const std::thread::id caller = std::this_thread::get_id();
    std::atomic<std::uint32_t> done = 0;
    parallelFor(threads_, subtrees_.size(), [&](std::size_t i) {
      built[i] = buildSubtree(primitives_, subtrees_[i].range);
      done += subtrees_[i].range.size();
      if (progress && std::this_thread::get_id() == caller)
        progress(static_cast<float>(done) / static_cast<float>(primitives_.boxes.size()));
    });
    std::size_t size = nodes_.size();
    for (const auto& nodes : built) size += nodes.size() - 1;
    nodes_.reserve(size);
    for (std::size_t i = 0; i < built.size(); ++i) {
      append(std::move(built[i]), subtrees_[i].node);
    }
  }

  // The subtree's root takes the place that it has among the nodes; the others follow at the end.
  void append(std::vector<BvhNode> subtree, std::uint32_t root) {
    const auto shift = static_cast<std::uint32_t>(nodes_.size() - 1);
    for (BvhNode& node : subtree)
      if (!node.leaf()) node.first += shift;
    nodes_[root] = subtree.front();
    nodes_.insert(nodes_.end(), subtree.begin() + 1, subtree.end());
  }

  unsigned threads_;
  const WorkProgress& progress_;
  float divided_ = 0;  // primitives, at each level in which they are
  BvhPrimitives primitives_;
  std::vector<BvhNode> nodes_;
  std::vector<Task> subtrees_;
};

// Keeps the tree where reinsertion would make it too deep for a stack that it fits now.
Bvh improved(Bvh bvh, const WorkProgress& progress) {
  Bvh better = bvh;
  reinsertNodes(better.nodes, progress);
  const std::size_t most = std::max<std::size_t>(stackSizeOf(bvh), STACK_SIZE);
  return stackSizeOf(better) <= most ? better : bvh;
}

}  // namespace

Bvh buildBvh(const std::vector<Bounds>& boxes, unsigned threads, const WorkProgress& progress) {
  if (threads == 0) threads = std::max(std::thread::hardware_concurrency(), 1u);
  const bool improve = boxes.size() <= kMostReinserted;
  const WorkProgress building = partOf(progress, 0, improve ? kReinsertionBegins : 1);
  Bvh bvh = Builder(boxes, threads, building).build();
  if (improve) bvh = improved(std::move(bvh), partOf(progress, kReinsertionBegins, 1));
  if (progress) progress(1);
  return bvh;
}

}  // namespace glimt
