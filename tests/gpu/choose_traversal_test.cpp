// Which traversal `auto` is: one that can hold the scene's tree.
#include <catch2/catch.hpp>

#include "renderer/core/error.h"
#include "renderer/passes/data_texture.h"
#include "renderer/passes/scene_tree.h"
#include "shaders/layout.h"
#include "tests/gpu/coincident_triangles.h"
#include "tests/unit/expect_error.h"

using namespace glimt;

namespace {

// Every inner node has a leaf for its lower child; `primitives` is what the tree says it holds.
Bvh chain(std::size_t inner_nodes, std::size_t primitives) {
  Bvh bvh;
  bvh.nodes.resize(2 * inner_nodes + 1);
  for (std::size_t i = 0; i < inner_nodes; ++i) {
    const std::size_t node = i == 0 ? 0 : 2 * i;
    bvh.nodes[node].first = static_cast<std::uint32_t>(2 * i + 1);
    bvh.nodes[2 * i + 1].count = 1;
  }
  bvh.nodes.back().count = 1;
  bvh.order.resize(primitives);
  return bvh;
}

ContextInfo contextOf(int gles, bool software) {
  ContextInfo context;
  context.gles = gles;
  context.software = software;
  return context;
}

const ContextInfo kCpu = contextOf(2, true);
const ContextInfo kGpu = contextOf(2, false);

constexpr int kUsualTexture = 16384;  // pixels a side

std::string choose(const std::string& asked, const Bvh& bvh, const ContextInfo& context,
                   int max_texture_size = kUsualTexture) {
  return candidateTraversals(asked, bvh, context, mostTexels(max_texture_size)).front();
}

}  // namespace

TEST_CASE("auto takes the octants for small trees, however deep they are") {
  CHECK(choose("auto", chain(3, 1000), kCpu) == "octant-ahead");
  CHECK(choose("auto", chain(100, 1000), kCpu) == "octant-ahead");
}

TEST_CASE("auto looks one node ahead on a CPU only") {
  CHECK(choose("auto", chain(3, 1000), kCpu) == "octant-ahead");
  CHECK(choose("auto", chain(3, 1000), kGpu) == "octant");
}

TEST_CASE("auto takes the stack for large trees only while it is deep enough") {
  CHECK(choose("auto", chain(STACK_SIZE - 1, 600000), kCpu) == "stack");
  CHECK(choose("auto", chain(STACK_SIZE, 600000), kCpu) == "skip");
}

TEST_CASE("what auto tries besides has the same layout of the tree") {
  for (const bool software : {true, false})
    for (const std::size_t primitives : {1000u, 600000u}) {
      const auto candidates = candidateTraversals(
          "auto", chain(3, primitives), contextOf(2, software), mostTexels(kUsualTexture));
      for (const std::string& candidate : candidates)
        CHECK(traversalNamed(candidate).layout == traversalNamed(candidates.front()).layout);
    }
}

TEST_CASE("auto leaves the octants where eight copies do not fit into a texture") {
  const Bvh bvh = chain(20, 1000);  // 41 nodes: 336 texels with one at each copy's end
  CHECK(choose("auto", bvh, kCpu, 32) == "octant-ahead");
  CHECK(choose("auto", bvh, kCpu, 16) == "stack");
}

TEST_CASE("a scene is refused where its triangles do not fit into the device's textures") {
  CHECK(mostTriangles(16384) == (1u << 23) / 3);  // indices have 23 bits
  CHECK(mostTriangles(64) == 64 * 64 / 3);
  CHECK(mostTriangles(100) == 64 * 64 / 3);  // sizes are powers of two
  CHECK(buildSceneTree(test::coincidentTriangles(1365), 64).bvh.order.size() == 1365);
  const std::string message =
      messageOf(ErrorKind::input, [] { buildSceneTree(test::coincidentTriangles(1366), 64); });
  CHECK(message.find("1,366 triangles") != std::string::npos);
  CHECK(message.find("1,365 fit") != std::string::npos);
}

TEST_CASE("a traversal that is asked for by name is taken, and an unknown one is refused") {
  CHECK(choose("trail", chain(3, 1000), kCpu) == "trail");
  CHECK_THROWS_AS(choose("magic", chain(3, 1000), kCpu), Error);
}

TEST_CASE("a traversal for ES 3.0 is refused in a context of ES 2.0, with what to do") {
  for (const Traversal& traversal : traversals()) {
    CAPTURE(traversal.name);
    CHECK(choose(traversal.name, chain(3, 1000), contextOf(3, true)) == traversal.name);
    if (traversal.gles == 2) continue;
    CHECK_THROWS_WITH(choose(traversal.name, chain(3, 1000), kCpu),
                      Catch::Contains(traversal.name) && Catch::Contains("--gles 3"));
  }
}

TEST_CASE("auto takes what runs in ES 2.0, whatever the context") {
  for (const bool software : {true, false})
    for (const std::size_t primitives : {1000u, 600000u})
      for (const std::size_t depth : {3u, 100u}) {
        const std::string chosen = choose("auto", chain(depth, primitives), contextOf(3, software));
        CHECK(traversalNamed(chosen).gles == 2);
      }
}
