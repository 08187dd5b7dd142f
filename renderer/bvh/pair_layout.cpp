#include <algorithm>

#include "renderer/bvh/node_grid.h"
#include "renderer/bvh/node_layout.h"
#include "shaders/layout.h"

namespace glimt {
namespace {

constexpr auto kRoot = static_cast<std::size_t>(ROOT_PAIR);

// Children are neighbours in a Bvh already: node 0 moves to kRoot, and the others by two more.
std::size_t placeOf(std::size_t node) {
  return node == 0 ? kRoot : kRoot + 1 + node;
}

Vec4 texelOf(const BvhNode& node, const NodeGrid& grid) {
  const float link = node.leaf() ? -1.0f - static_cast<float>(node.first)
                                 : static_cast<float>(placeOf(node.first));
  return {NodeGrid::packed(grid.below(node.bounds.min), grid.above(node.bounds.max)), link};
}

}  // namespace

NodeLayout layOutPairs(const Bvh& bvh) {
  const NodeGrid grid(bvh);
  NodeLayout layout{{}, bvh.nodes.size(), grid.origin(), grid.cell()};
  layout.texels.assign(kRoot + 1 + std::max<std::size_t>(bvh.nodes.size(), 1), Vec4(0));
  for (std::size_t i = 0; i < bvh.nodes.size(); ++i)
    layout.texels[placeOf(i)] = texelOf(bvh.nodes[i], grid);
  // Beside the root stands the end, in the same box: of two at one distance the first is visited
  // first.
  if (!bvh.nodes.empty()) layout.texels[kRoot + 1] = Vec4(Vec3(layout.texels[kRoot]), 0.0f);
  return layout;
}

std::size_t stackSizeOf(const Bvh& bvh) {
  std::vector<std::size_t> above(bvh.nodes.size(), 0);
  std::size_t deepest = 0;
  for (std::size_t i = 0; i < bvh.nodes.size(); ++i) {
    const BvhNode& node = bvh.nodes[i];
    deepest = std::max(deepest, above[i]);
    if (node.leaf()) continue;
    above[node.first] = above[i] + 1;
    above[node.first + 1] = above[i] + 1;
  }
  return deepest + 1;
}

}  // namespace glimt
