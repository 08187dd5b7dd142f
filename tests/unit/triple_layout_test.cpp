// The tree with ways up: every node's way up leads to the node above it.
#include <catch2/catch.hpp>
#include <cmath>

#include "renderer/bvh/node_layout.h"
#include "shaders/layout.h"

using namespace glimt;

namespace {

constexpr float kUpper = 1;
constexpr float kLower = -1;

Bvh treeOverPoints(int count) {
  std::vector<Bounds> boxes;
  for (int i = 0; i < count; ++i) {
    const auto x = static_cast<float>(i * i % 101);
    const auto y = static_cast<float>(i * 37 % 89);
    Bounds box;
    box.include(Vec3(x, y, static_cast<float>(i)));
    boxes.push_back(box);
  }
  return buildBvh(boxes);
}

// Visits the node beside `between` and those below it, as a traversal finds them. Returns how many
// primitives are in their leaves.
std::size_t visit(const Bvh& bvh, const NodeLayout& layout, std::size_t node, float between,
                  float side) {
  const auto texel = [&](float index) { return layout.texels.at(static_cast<std::size_t>(index)); };
  const Vec4 found = texel(between + side);
  if (bvh.nodes[node].leaf()) {
    CHECK(found.w == -1.0f - static_cast<float>(bvh.nodes[node].first));
    CHECK(glm::all(glm::greaterThan(Vec3(found), Vec3(0))));
    return bvh.nodes[node].count;
  }
  const Vec4 up = texel(found.w);
  CHECK(std::abs(up.x) == between);
  CHECK(std::signbit(up.x) == (side == kLower));
  for (int axis = 0; axis < 3; ++axis) {
    CHECK((found[axis] < 0) == (axis == bvh.nodes[node].axis));
    CHECK(up[1 + axis] == (axis == bvh.nodes[node].axis ? 1 : 0));
  }
  const std::size_t lower = bvh.nodes[node].first;
  return visit(bvh, layout, lower, found.w, kLower) +
         visit(bvh, layout, lower + 1, found.w, kUpper);
}

}  // namespace

TEST_CASE("From every pair of nodes a way leads up to the node above it") {
  for (const int count : {1, 2, 9, 1000}) {
    const Bvh bvh = treeOverPoints(count);
    const NodeLayout layout = layOutTriples(bvh);
    CHECK(layout.texels.at(static_cast<std::size_t>(ROOT_TRIPLE)).x == 0);
    CHECK(visit(bvh, layout, 0, ROOT_TRIPLE, kLower) == static_cast<std::size_t>(count));
  }
}

TEST_CASE("Without primitives there is a root, and nothing below it") {
  const NodeLayout layout = layOutTriples({});
  CHECK(layout.texels.at(static_cast<std::size_t>(ROOT_TRIPLE) - 1).w == 0);
}
