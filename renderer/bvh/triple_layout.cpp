#include "renderer/bvh/node_grid.h"
#include "renderer/bvh/node_layout.h"
#include "shaders/layout.h"

namespace glimt {
namespace {

constexpr auto kRoot = static_cast<std::size_t>(ROOT_TRIPLE);

// Children are neighbours in a Bvh, from node 1 on. Where what is between two of them goes, by the
// lower one; the first three texels are the root's.
std::size_t betweenOf(std::size_t lower) {
  return kRoot + 3 * ((lower - 1) / 2 + 1);
}

// The side of a node in its pair: -1 the lower, 1 the upper. The root is a lower one.
int sideOf(std::size_t node) {
  return node == 0 || node % 2 == 1 ? -1 : 1;
}

// What is beside it.
std::size_t betweenBeside(std::size_t node) {
  if (node == 0) return kRoot;
  return betweenOf(sideOf(node) < 0 ? node : node - 1);
}

Vec4 childTexel(const BvhNode& node, const NodeGrid& grid) {
  Vec3 box = NodeGrid::packed(grid.below(node.bounds.min), grid.above(node.bounds.max));
  if (node.leaf()) return {box, -1.0f - static_cast<float>(node.first)};
  box[node.axis] *= -1.0f;
  return {box, static_cast<float>(betweenOf(node.first))};
}

Vec4 texelBetweenChildrenOf(std::size_t node, int axis) {
  Vec4 texel(static_cast<float>(sideOf(node)) * static_cast<float>(betweenBeside(node)), Vec3(0));
  texel[1 + axis] = 1;
  return texel;
}

}  // namespace

NodeLayout layOutTriples(const Bvh& bvh) {
  const NodeGrid grid(bvh);
  NodeLayout layout{{}, bvh.nodes.size(), grid.origin(), grid.cell()};
  layout.texels.assign(3 * (bvh.nodes.size() / 2 + 1), Vec4(0));
  for (std::size_t i = 0; i < bvh.nodes.size(); ++i) {
    const BvhNode& node = bvh.nodes[i];
    layout.texels[betweenBeside(i) + static_cast<std::size_t>(sideOf(i))] = childTexel(node, grid);
    if (!node.leaf()) layout.texels[betweenOf(node.first)] = texelBetweenChildrenOf(i, node.axis);
  }
  return layout;
}

}  // namespace glimt
