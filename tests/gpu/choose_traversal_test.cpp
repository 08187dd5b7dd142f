// Which traversal `auto` is: one that can hold the scene's tree.
#include <catch2/catch.hpp>

#include "renderer/core/error.h"
#include "renderer/passes/scene_tree.h"
#include "shaders/layout.h"

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

}  // namespace

TEST_CASE("auto takes the octants for small trees, however deep they are") {
  CHECK(chooseTraversal("auto", chain(3, 1000), kCpu) == "octant-ahead");
  CHECK(chooseTraversal("auto", chain(100, 1000), kCpu) == "octant-ahead");
}

TEST_CASE("auto looks one node ahead on a CPU only") {
  CHECK(chooseTraversal("auto", chain(3, 1000), kCpu) == "octant-ahead");
  CHECK(chooseTraversal("auto", chain(3, 1000), kGpu) == "octant");
}

TEST_CASE("auto takes the stack for large trees only while it is deep enough") {
  CHECK(chooseTraversal("auto", chain(STACK_SIZE - 1, 600000), kCpu) == "stack");
  CHECK(chooseTraversal("auto", chain(STACK_SIZE, 600000), kCpu) == "skip");
}

TEST_CASE("a traversal that is asked for by name is taken, and an unknown one is refused") {
  CHECK(chooseTraversal("trail", chain(3, 1000), kCpu) == "trail");
  CHECK_THROWS_AS(chooseTraversal("magic", chain(3, 1000), kCpu), Error);
}

TEST_CASE("a traversal for ES 3.0 is refused in a context of ES 2.0, with what to do") {
  for (const Traversal& traversal : traversals()) {
    CAPTURE(traversal.name);
    CHECK(chooseTraversal(traversal.name, chain(3, 1000), contextOf(3, true)) == traversal.name);
    if (traversal.gles == 2) continue;
    CHECK_THROWS_WITH(chooseTraversal(traversal.name, chain(3, 1000), kCpu),
                      Catch::Contains(traversal.name) && Catch::Contains("--gles 3"));
  }
}

TEST_CASE("auto takes what runs in ES 2.0, whatever the context") {
  for (const bool software : {true, false})
    for (const std::size_t primitives : {1000u, 600000u})
      for (const std::size_t depth : {3u, 100u}) {
        const std::string chosen =
            chooseTraversal("auto", chain(depth, primitives), contextOf(3, software));
        CHECK(traversalNamed(chosen).gles == 2);
      }
}
