// Some drivers end all loops of an invocation after a number of turns, without a word: llvmpipe
// after some 65,500. A traversal that is cut short has to say so.
#include <fmt/format.h>

#include <algorithm>
#include <catch2/catch.hpp>

#include "renderer/probes/loop_turns.h"
#include "shaders/layout.h"
#include "tests/gpu/contexts.h"
#include "tests/gpu/probe.h"
#include "tests/gpu/traversal_probe.h"
#include "tests/shader/report.h"

using namespace glimt;
using test::TestContext;

namespace {

// Triangles that all fill the same box, so that a ray through the box has to look at every one of
// them. Only `target` is in the ray's way.
Scene crowdedScene(std::uint32_t triangles, std::uint32_t target) {
  Scene scene;
  scene.positions = {{-1, -1, -1}, {1, 1, 1}, {1, 1, 0.5f}, {1, -1, -1}, {-1, -1, 1}};
  scene.materials.resize(2);
  for (std::uint32_t i = 0; i < triangles; ++i) {
    Triangle triangle;
    if (i == target)
      triangle.positions = {3, 1, 4};
    else
      triangle.positions = {0, 1, 2};
    triangle.material = i == target ? 1 : 0;
    scene.triangles.push_back(triangle);
  }
  return scene;
}

constexpr std::size_t kRays = 64;
constexpr float kDistance = 2.5f;  // in lengths of the direction

// In the plane x = y + 1, where the others are not, and rays beside the box among them.
bool inTheWay(std::size_t ray) {
  return ray % 3 != 0;
}

std::vector<Vec4> origins() {
  std::vector<Vec4> list;
  for (std::size_t i = 0; i < kRays; ++i) list.emplace_back(-2, -3, inTheWay(i) ? -0.5f : 5.0f, 0);
  return list;
}

std::vector<Vec4> directions(float length) {
  return std::vector<Vec4>(kRays, length * Vec4(1, 1, 0.2f, 0));
}

enum class Outcome { right, unknown, wrong };

class CrowdedTest {
 public:
  explicit CrowdedTest(const TestContext& context,
                       const Traversal& traversal = traversals().front())
      : device_(context.device()),
        layout_(traversal.layout),
        closest_(context.device(), test::kClosestHit, traversal.name),
        any_(context.device(), test::kVisibility, traversal.name) {}

  // What comes of the rays, at the worst.
  Outcome trace(std::uint32_t triangles, std::uint32_t target) {
    const SceneTextures textures(device_, crowdedScene(triangles, target), layout_);
    return std::max(closestHits(textures), visibilities(textures));
  }

  // The smallest number of triangles that is too many, or none.
  std::uint32_t firstUnknown() {
    std::uint32_t fits = 1000;
    std::uint32_t too_many = 128000;
    if (trace(too_many, too_many - 1) == Outcome::right) return 0;
    while (too_many - fits > 1) {
      const std::uint32_t middle = (fits + too_many) / 2;
      (trace(middle, middle - 1) == Outcome::right ? fits : too_many) = middle;
    }
    return too_many;
  }

 private:
  Outcome closestHits(const SceneTextures& textures) {
    const std::vector<Vec4> hits = closest_.run(textures, {origins(), directions(1)}, kRays);
    Outcome worst = Outcome::right;
    for (std::size_t i = 0; i < kRays; ++i) {
      const Vec4& hit = hits[i];
      const bool found = hit.x == test::kHit && hit.y == 1 && std::abs(hit.z - kDistance) < 1e-5f;
      const bool right = inTheWay(i) ? found : hit.x == test::kMiss;
      worst = std::max(worst, right                     ? Outcome::right
                              : hit.x == test::kUnknown ? Outcome::unknown
                                                        : Outcome::wrong);
    }
    return worst;
  }

  Outcome visibilities(const SceneTextures& textures) {
    const std::vector<Vec4> seen = any_.run(textures, {origins(), directions(10)}, kRays);
    Outcome worst = Outcome::right;
    for (std::size_t i = 0; i < kRays; ++i) {
      const bool right = seen[i].x == (inTheWay(i) ? 0.0f : 1.0f);
      worst = std::max(worst, right           ? Outcome::right
                              : seen[i].x < 0 ? Outcome::unknown
                                              : Outcome::wrong);
    }
    return worst;
  }

  const gl::Device& device_;
  TreeLayout layout_;
  test::TraversalProbe closest_;
  test::TraversalProbe any_;
};

// Each traversal on each driver: contexts of the same one would repeat it.
bool isToBeTested(const Traversal& traversal, const TestContext& context) {
  if (traversal.gles > context.gles()) return false;
  const TestContext& first = test::contexts().front();
  return !context.egl() || &context == &first || traversal.gles > first.gles();
}

bool isLlvmpipe(const TestContext& context) {
  return context.device().info().renderer.find("llvmpipe") != std::string::npos;
}

}  // namespace

TEST_CASE("how many turns of loops a driver makes") {
  test::onEveryContext([](const TestContext& context) {
    const auto limit = findLoopLimit(context.device(), 200000);
    test::report("{}: loops end after {}", context.name(),
                 limit ? fmt::format("{} turns", *limit) : "as many turns as they ask for");
    if (isLlvmpipe(context)) CHECK(limit.has_value());
    CHECK(limit.value_or(200000) > 60000);  // fewer would not be enough for large scenes
    LoopProbe probe(context.device());
    for (const std::uint32_t wanted : {0u, 1u, 1000u, 60000u}) CHECK(probe.turns(wanted) == wanted);
  });
}

TEST_CASE("a crowded scene that fits is traced right") {
  test::onEveryContext([](const TestContext& context) {
    for (const Traversal& traversal : traversals()) {
      if (traversal.gles > context.gles()) continue;
      CAPTURE(context.name(), traversal.name);
      CrowdedTest crowded(context, traversal);
      for (const std::uint32_t target : {0u, 777u, 999u})
        CHECK(crowded.trace(1000, target) == Outcome::right);
    }
  });
}

TEST_CASE("a traversal that is cut short is unknown, not wrong") {
  test::onEveryContext([](const TestContext& context) {
    for (const Traversal& traversal : traversals()) {
      if (!isToBeTested(traversal, context)) continue;
      CAPTURE(context.name(), traversal.name);
      CrowdedTest crowded(context, traversal);
      for (const std::uint32_t target : {0u, 35000u, 69999u}) {
        const Outcome outcome = crowded.trace(70000, target);
        CHECK(outcome != Outcome::wrong);
        if (isLlvmpipe(context)) CHECK(outcome == Outcome::unknown);
      }
    }
  });
}

TEST_CASE("no traversal is wrong at any turn at which it is cut short") {
  test::onEveryContext([](const TestContext& context) {
    // One driver after another: contexts of the same one would repeat it.
    if (context.egl() && &context != &test::contexts().front()) return;
    CAPTURE(context.name());
    CrowdedTest crowded(context);
    const std::uint32_t limit = crowded.firstUnknown();
    test::report(
        "{}: {}", context.name(),
        limit ? fmt::format("{} triangles in one box are too many", limit) : "no limit was found");
    if (isLlvmpipe(context)) CHECK(limit > 0);
    if (limit == 0) return;
    for (std::uint32_t triangles = limit - 12; triangles <= limit + 12; ++triangles) {
      CAPTURE(triangles);
      CHECK(crowded.trace(triangles, 0) != Outcome::wrong);
      CHECK(crowded.trace(triangles, triangles - 1) != Outcome::wrong);
    }
  });
}

// What `glimt render --traversal linear` goes by: see renderer.cpp.
TEST_CASE("the linear traversal looks at as many triangles as the driver makes turns") {
  test::onEveryContext([](const TestContext& context) {
    CAPTURE(context.name());
    constexpr std::uint32_t kSteps = MAX_STEPS;
    const std::uint32_t most = LoopProbe(context.device()).turns(kSteps);
    CrowdedTest crowded(context, traversalNamed("linear"));
    CHECK(crowded.trace(most, most - 1) == Outcome::right);
    CHECK(crowded.trace(most + 1, most) == Outcome::unknown);
  });
}
