// A traversal holds trees as deep as the table says: those with as many levels as it holds are the
// ones in which a stack is full and a trail uses its last bit.
#include <algorithm>
#include <catch2/catch.hpp>

#include "tests/gpu/contexts.h"
#include "tests/gpu/traversal_probe.h"

using namespace glimt;
using test::TestContext;

namespace {

// More than any traversal with a limit holds.
constexpr std::size_t kDeepest = 60;

// Triangles one behind the other along z, one metre apart, which fill one half of a square. Only
// `target` fills the other one, so that a ray through that half enters every box for nothing else.
Scene rowOfTriangles(std::size_t count, std::size_t target) {
  Scene scene;
  scene.materials.resize(1);
  for (std::size_t i = 0; i < count; ++i) {
    const auto z = static_cast<float>(i);
    const float corner = i == target ? 1.0f : 0.0f;
    const auto first = static_cast<std::uint32_t>(scene.positions.size());
    for (const Vec2 p : {Vec2(corner, corner), Vec2(0, 1), Vec2(1, 0)})
      scene.positions.emplace_back(p, z);
    Triangle triangle;
    triangle.positions = {first, first + 1, first + 2};
    scene.triangles.push_back(triangle);
  }
  return scene;
}

// Every inner node has a leaf for its lower child.
Bvh chainOver(std::size_t leaves) {
  const auto last = static_cast<float>(leaves - 1);
  Bvh bvh;
  for (std::size_t i = 0; i < leaves; ++i) {
    const auto z = static_cast<float>(i);
    BvhNode leaf;
    leaf.bounds = {Vec3(0, 0, z), Vec3(1, 1, z)};
    leaf.first = static_cast<std::uint32_t>(i);
    leaf.count = 1;
    BvhNode inner;
    inner.bounds = {Vec3(0, 0, z), Vec3(1, 1, last)};
    inner.first = static_cast<std::uint32_t>(2 * i + 1);
    inner.axis = 2;
    if (i + 1 < leaves) bvh.nodes.push_back(inner);  // before it, the leaf beside it
    bvh.nodes.push_back(leaf);
    bvh.order.push_back(static_cast<std::uint32_t>(i));
  }
  return bvh;
}

// From both ends, and from between the triangles, along z.
std::vector<std::vector<Vec4>> raysAlong(std::size_t count) {
  std::vector<std::vector<Vec4>> rays(2);
  for (std::size_t i = 0; i <= count; ++i)
    for (const float direction : {1.0f, -1.0f}) {
      rays[0].emplace_back(0.75f, 0.75f, static_cast<float>(i) - 0.5f, 0);
      rays[1].emplace_back(0, 0, direction, 0);
    }
  return rays;
}

void checkHits(const TestContext& context, const Traversal& traversal, std::size_t levels,
               std::size_t target) {
  const std::size_t leaves = levels;  // of a chain with levels - 1 inner nodes
  const Scene scene = rowOfTriangles(leaves, target);
  const SceneTextures textures(context.device(), scene, {chainOver(leaves), 0}, traversal.layout);
  REQUIRE(textures.stackSize() == levels);
  const auto rays = raysAlong(leaves);
  test::TraversalProbe closest(context.device(), test::kClosestHit, traversal.name);
  const std::vector<Vec4> hits = closest.run(textures, rays);
  for (std::size_t i = 0; i < hits.size(); ++i) {
    const float distance = (static_cast<float>(target) - rays[0][i].z) * rays[1][i].z;
    CAPTURE(levels, target, rays[0][i].z, rays[1][i].z);
    CHECK(hits[i].x == (distance > 0 ? test::kHit : test::kMiss));
    if (distance > 0) CHECK(hits[i].z == Approx(distance));
  }
}

}  // namespace

TEST_CASE("a traversal finds its way in the deepest trees that it holds") {
  test::onEveryContext([](const TestContext& context) {
    if (&context != &test::contexts().front() && context.gles() < 3) return;
    for (const Traversal& traversal : traversals()) {
      if (traversal.gles > context.gles()) continue;
      CAPTURE(context.name(), traversal.name);
      const std::size_t levels = std::min(traversal.most_levels, kDeepest);
      for (const std::size_t target : {std::size_t{0}, levels / 2, levels - 1})
        checkHits(context, traversal, levels, target);
    }
  });
}
