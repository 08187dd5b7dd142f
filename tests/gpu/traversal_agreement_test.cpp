// Every traversal against Embree, on the meshes and rays of `glimt bench`: camera rays and bounce
// rays by the distance of their closest hit, shadow rays by whether anything is in their way. A ray
// differs where one of the two hits and the other does not, or where distances are more than 1e-4
// of the distance apart. Of each kind one ray in ten thousand may differ: Embree is at its fastest,
// not at its most exact, and rays along an edge are rounded to either side. Rays cut short differ.
#include <algorithm>
#include <catch2/catch.hpp>

#include "renderer/bench.h"
#include "renderer/core/error.h"
#include "renderer/shader/traversals.h"
#include "tests/shader/report.h"

using namespace glimt;

namespace {

// A context for every traversal, else for those of ES 2.0.
ContextHandle latestContext() {
  try {
    return createOffscreenContext(Backend::automatic, 3);
  } catch (const Error& error) {
    test::report("traversals of ES 3.0 are not tested here: {}", error.what());
    return createOffscreenContext(Backend::automatic, 2);
  }
}

// The rays of a mesh are 3 * side * side.
void compareOn(const std::vector<std::size_t>& triangles, int side) {
  ContextHandle context = latestContext();
  const std::vector<TraversalRow> rows =
      benchTraversals(context, {triangles, side, 0}, [](const std::string&) {});
  std::size_t compared = 0;
  for (const TraversalRow& row : rows) {
    CAPTURE(row.traversal, row.triangles, row.different, row.compared);
    if (row.compared == 0) {
      test::report("{} triangles, {}: {}", row.triangles, row.traversal, row.note);
      CHECK_FALSE(row.note.empty());
      continue;
    }
    test::report("{} triangles, {}: {} of {} rays differ", row.triangles, row.traversal,
                 row.different, row.compared);
    CHECK(row.reference == kEmbree);
    CHECK(row.agrees);
    // Camera, bounce and shadow rays: nearly every camera ray hits something.
    CHECK(row.compared >
          static_cast<std::size_t>(side) * static_cast<std::size_t>(side) * 299 / 100);
    ++compared;
  }
  // Embree is a row of its own; on large meshes the linear loop and the octants may be left out.
  const auto runs = std::count_if(
      traversals().begin(), traversals().end(),
      [&](const Traversal& traversal) { return traversal.gles <= context.info().gles; });
  CHECK(compared >= triangles.size() * static_cast<std::size_t>(runs - 2));
}

}  // namespace

TEST_CASE("all traversals find what Embree finds") {
  compareOn({1000, 70000}, 96);
}

TEST_CASE("all traversals find what Embree finds, for a million rays a mesh", "[long]") {
  compareOn({1000, 70000, 500000, 2000000}, 579);
}
