#include "renderer/bvh/reinsertion.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace glimt {
namespace {

constexpr int kPasses = 2;

// How often progress is told: after so many nodes.
constexpr std::size_t kToldNodes = 512;

// In a pass those with the largest areas, where nearly all is to be gained.
constexpr std::size_t kShare = 10;  // one in so many

// Savings below this share of the root's area would be rounding.
constexpr float kLeastSaving = 1e-7f;

class Reinsertion {
 public:
  explicit Reinsertion(std::vector<BvhNode>& nodes) : nodes_(nodes), parents_(nodes.size(), 0) {
    for (std::uint32_t i = 0; i < nodes_.size(); ++i) adoptChildren(i);
  }

  void pass(const WorkProgress& progress) {
    const std::vector<std::uint32_t> order = largest();
    for (std::size_t i = 0; i < order.size(); ++i) {
      if (progress && i % kToldNodes == 0)
        progress(static_cast<float>(i) / static_cast<float>(order.size()));
      const std::uint32_t node = order[i];
      if (node == 0 || parents_[node] == 0) continue;
      const Place place = bestPlace(node);
      if (place.node != 0) move(node, place.node);
    }
  }

 private:
  struct Place {
    float saving = 0;        // in area of inner nodes, to which the tree's cost is proportional
    std::uint32_t node = 0;  // beside this one, below a new parent of both; 0 for none
  };

  static std::uint32_t siblingOf(std::uint32_t node) { return node % 2 == 1 ? node + 1 : node - 1; }

  void adoptChildren(std::uint32_t parent) {
    const BvhNode& node = nodes_[parent];
    if (!node.leaf()) parents_[node.first] = parents_[node.first + 1] = parent;
  }

  std::vector<std::uint32_t> largest() const {
    std::vector<float> areas;
    areas.reserve(nodes_.size());
    for (const BvhNode& node : nodes_) areas.push_back(node.bounds.halfArea());
    std::vector<std::uint32_t> order(nodes_.size());
    std::iota(order.begin(), order.end(), 0u);
    const auto end = order.begin() + static_cast<std::ptrdiff_t>(order.size() / kShare + 1);
    const auto larger = [&](std::uint32_t a, std::uint32_t b) {
      return areas[a] != areas[b] ? areas[a] > areas[b] : a < b;
    };
    std::nth_element(order.begin(), end, order.end(), larger);
    std::sort(order.begin(), end, larger);
    return {order.begin(), end};
  }

  // From the node's parent upwards: beside each ancestor, and all below the ancestor's sibling.
  Place bestPlace(std::uint32_t moved) {
    Place best{kLeastSaving * nodes_[0].bounds.halfArea(), 0};
    const std::uint32_t parent = parents_[moved];
    float saved = nodes_[parent].bounds.halfArea();  // by taking it out
    Bounds rest = nodes_[siblingOf(moved)].bounds;   // what the ancestor would contain without it
    searchBelow(siblingOf(moved), moved, saved, best);
    for (std::uint32_t ancestor = parent; ancestor != 0; ancestor = parents_[ancestor]) {
      const float area = nodes_[ancestor].bounds.halfArea();
      if (ancestor != parent) {
        saved += area - rest.halfArea();
        if (saved - area > best.saving) best = {saved - area, ancestor};
      }
      const std::uint32_t sibling = siblingOf(ancestor);
      searchBelow(sibling, moved, saved, best);
      rest.include(nodes_[sibling].bounds);
    }
    return best;
  }

  // Branch and bound: no place below a node can save more than what is left after growing all
  // nodes on the way, less the area of what is moved, which its new parent has at least.
  void searchBelow(std::uint32_t root, std::uint32_t moved, float saved, Place& best) {
    const Bounds& box = nodes_[moved].bounds;
    const float least = box.halfArea();
    search_.assign(1, {saved, root});
    while (!search_.empty()) {
      const Place place = search_.back();
      search_.pop_back();
      if (!(place.saving - least > best.saving)) continue;
      const BvhNode& node = nodes_[place.node];
      Bounds joint = node.bounds;
      joint.include(box);
      const float joint_area = joint.halfArea();
      const bool stays = place.node == siblingOf(moved);
      if (!stays && place.saving - joint_area > best.saving)
        best = {place.saving - joint_area, place.node};
      if (node.leaf()) continue;
      const float below = place.saving + node.bounds.halfArea() - joint_area;
      search_.push_back({below, node.first});
      search_.push_back({below, node.first + 1});
    }
  }

  // The sibling takes the parent's place, and what is at `place` the sibling's; then the parent's
  // pair of children hangs there.
  void move(std::uint32_t moved, std::uint32_t place) {
    const std::uint32_t parent = parents_[moved];
    const std::uint32_t pair = nodes_[parent].first;
    const std::uint32_t sibling = siblingOf(moved);
    nodes_[parent] = nodes_[sibling];
    adoptChildren(parent);
    nodes_[sibling] = nodes_[place];
    adoptChildren(sibling);
    nodes_[place].first = pair;
    nodes_[place].count = 0;
    adoptChildren(place);
    refitFrom(place);
    refitFrom(parents_[parent]);
  }

  void refitFrom(std::uint32_t node) {
    for (bool root = false; !root; node = parents_[node]) {
      root = node == 0;
      nodes_[node].bounds = nodes_[nodes_[node].first].bounds;
      nodes_[node].bounds.include(nodes_[nodes_[node].first + 1].bounds);
    }
  }

  std::vector<BvhNode>& nodes_;
  std::vector<std::uint32_t> parents_;
  std::vector<Place> search_;
};

void orderChildren(BvhNode& parent, BvhNode& lower, BvhNode& upper) {
  const Vec3 way = upper.bounds.center() - lower.bounds.center();
  int axis = 0;
  for (int other = 1; other < 3; ++other)
    if (std::abs(way[other]) > std::abs(way[axis])) axis = other;
  parent.axis = static_cast<std::uint8_t>(axis);
  if (way[axis] < 0) std::swap(lower, upper);
}

std::vector<BvhNode> depthFirst(const std::vector<BvhNode>& nodes) {
  std::vector<BvhNode> result{nodes[0]};
  result.reserve(nodes.size());
  std::vector<std::uint32_t> stack{0};
  while (!stack.empty()) {
    BvhNode& node = result[stack.back()];  // stays where it is, as there is room for all
    stack.pop_back();
    if (node.leaf()) continue;
    const auto lower = static_cast<std::uint32_t>(result.size());
    result.push_back(nodes[node.first]);
    result.push_back(nodes[node.first + 1]);
    orderChildren(node, result[lower], result[lower + 1]);
    node.first = lower;
    stack.push_back(lower + 1);
    stack.push_back(lower);
  }
  return result;
}

}  // namespace

void reinsertNodes(std::vector<BvhNode>& nodes, const WorkProgress& progress) {
  if (nodes.size() < 4) return;
  Reinsertion reinsertion(nodes);
  for (int i = 0; i < kPasses; ++i)
    reinsertion.pass(
        partOf(progress, static_cast<float>(i) / kPasses, static_cast<float>(i + 1) / kPasses));
  nodes = depthFirst(nodes);
}

}  // namespace glimt
