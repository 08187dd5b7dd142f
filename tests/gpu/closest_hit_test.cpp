// The production traversal against Embree, on a million rays.
#include <catch2/catch.hpp>
#include <cmath>

#include "renderer/bench/embree_scene.h"
#include "tests/gpu/contexts.h"
#include "tests/gpu/exact_hits.h"
#include "tests/gpu/test_rays.h"
#include "tests/gpu/test_scene.h"
#include "tests/gpu/traversal_probe.h"
#include "tests/shader/report.h"

using namespace glimt;
using test::Rays;

namespace {

constexpr std::size_t kRays = 1000000;

// More differences than this fail a test anyway.
constexpr std::size_t kMostJudged = 200;

std::optional<MeshHit> asHit(const Vec4& found) {
  if (found.x != test::kHit) return std::nullopt;
  return MeshHit{static_cast<std::uint32_t>(found.y), found.z};
}

struct Comparison {
  std::size_t hits = 0;
  std::size_t unknown = 0;
  std::size_t only_embree = 0;  // found something
  std::size_t only_glimt = 0;
  std::size_t ties = 0;     // another triangle at the same distance
  std::size_t further = 0;  // distances differ
  double highest = 0;       // start of a ray in `further` over the plane of its triangle, metres
  std::size_t glimt_wrong = 0;  // by the exact hits
  std::size_t embree_wrong = 0;
  std::size_t judged = 0;
  double worst = 0;  // relative difference of distances, but for `further`
};

bool near(float a, float b) {
  return std::abs(a - b) <= 1e-5f * std::abs(b);
}

// Compares one ray. True if the two need a judge.
bool differ(Comparison& sum, const std::optional<MeshHit>& glimt,
            const std::optional<MeshHit>& embree) {
  if (glimt) ++sum.hits;
  if (!glimt && !embree) return false;
  if (!glimt || !embree) {
    ++(glimt ? sum.only_glimt : sum.only_embree);
    return true;
  }
  if (!near(glimt->t, embree->t)) {
    ++sum.further;
    return true;
  }
  sum.worst = std::max(sum.worst, std::abs(double(glimt->t) - embree->t) / embree->t);
  if (glimt->triangle == embree->triangle) return false;
  ++sum.ties;
  return true;
}

Comparison compare(const Scene& scene, const Rays& rays, const std::vector<Vec4>& found,
                   const std::vector<std::optional<MeshHit>>& expected) {
  Comparison sum;
  for (std::size_t i = 0; i < rays.size(); ++i) {
    const std::optional<MeshHit> glimt = asHit(found[i]);
    if (found[i].x == test::kUnknown) ++sum.unknown;
    if (!differ(sum, glimt, expected[i]) || ++sum.judged > kMostJudged) continue;
    const test::ExactHits exact(scene, rays.origin(i), rays.direction(i));
    if (glimt && expected[i] && !near(glimt->t, expected[i]->t))
      sum.highest = std::max(sum.highest, double(glimt->t) * exact.steepness(glimt->triangle));
    if (!exact.allows(glimt)) ++sum.glimt_wrong;
    if (!exact.allows(expected[i])) ++sum.embree_wrong;
  }
  return sum;
}

// The first context that it runs on.
const test::TestContext* firstFor(const Traversal& traversal) {
  for (const test::TestContext& context : test::contexts())
    if (context.gles() >= traversal.gles) return &context;
  return nullptr;
}

// Each traversal that holds the scene's tree on one context, and the first traversal on each
// driver. The linear one would take minutes and, on llvmpipe, more turns than a loop has.
template <class Test>
void onEveryTraversal(const std::string& name, const Scene& scene, const Test& test) {
  test::onEveryContext([&](const test::TestContext& context) {
    for (const Traversal& traversal : traversals()) {
      if (traversal.layout == TreeLayout::none) continue;
      const bool another_driver = !context.egl() && traversal.name == traversals().front().name;
      if (&context != firstFor(traversal) && !another_driver) continue;
      const SceneTextures textures(context.device(), scene, traversal.layout);
      if (textures.stackSize() > traversal.most_levels) {
        test::report("{}: too deep for {}", name, traversal.name);
        continue;
      }
      CAPTURE(context.name(), name, traversal.name);
      test(context, traversal, textures);
    }
  });
}

void compareClosestHits(const std::string& name, const Scene& scene, const Rays& rays) {
  const EmbreeScene embree(scene, RTC_SCENE_FLAG_ROBUST);
  std::vector<std::optional<MeshHit>> expected;
  for (std::size_t i = 0; i < rays.size(); ++i)
    expected.push_back(embree.closestHit(rays.origin(i), rays.direction(i)));

  onEveryTraversal(
      name, scene,
      [&](const test::TestContext& context, const Traversal& traversal,
          const SceneTextures& textures) {
        test::TraversalProbe probe(context.device(), test::kClosestHit, traversal.name);
        const std::vector<Vec4> found = probe.run(textures, {rays.origins, rays.directions});
        const Comparison sum = compare(scene, rays, found, expected);
        test::report(
            "{}, {}, {}: {} of {} rays hit, t differs from Embree's by up to {:.1e}; {} hit only "
            "here, "
            "{} only in Embree, {} another triangle at the same distance, {} at another distance "
            "from "
            "starts of up to {:.1e} m off its plane; of these glimt is wrong in {}, Embree in {}",
            name, context.name(), traversal.name, sum.hits, rays.size(), sum.worst, sum.only_glimt,
            sum.only_embree, sum.ties, sum.further, sum.highest, sum.glimt_wrong, sum.embree_wrong);
        CHECK(sum.hits > rays.size() / 2);
        CHECK(sum.unknown == 0);
        CHECK(sum.only_glimt + sum.only_embree == 0);
        CHECK(sum.judged <= kMostJudged);
        // Rays that graze a triangle or start close to it: the height of their start is what
        // decides the distance, and loses the same bits wherever it is.
        CHECK(sum.highest < 2e-3);
        CHECK(sum.glimt_wrong == 0);
      });
}

void compareVisibility(const std::string& name, const Scene& scene) {
  const Rays rays = test::segmentsIn(test::boundsOf(scene), kRays);
  const EmbreeScene embree(scene, RTC_SCENE_FLAG_ROBUST);
  std::vector<bool> occluded;
  for (std::size_t i = 0; i < rays.size(); ++i)
    occluded.push_back(embree.occluded(rays.origin(i), rays.direction(i)));

  onEveryTraversal(
      name, scene,
      [&](const test::TestContext& context, const Traversal& traversal,
          const SceneTextures& textures) {
        test::TraversalProbe probe(context.device(), test::kVisibility, traversal.name);
        const std::vector<Vec4> seen = probe.run(textures, {rays.origins, rays.directions});
        std::size_t visible = 0, unknown = 0, different = 0, wrong = 0;
        for (std::size_t i = 0; i < rays.size(); ++i) {
          if (seen[i].x > 0) ++visible;
          if (seen[i].x < 0) ++unknown;
          const bool blocked = seen[i].x == 0;
          if (blocked == occluded[i]) continue;
          if (++different > kMostJudged) continue;
          if (!test::ExactHits(scene, rays.origin(i), rays.direction(i)).allowsOccluded(blocked))
            ++wrong;
        }
        test::report(
            "{}, {}, {}: {} of {} segments are free; {} differ from Embree, {} of them wrong", name,
            context.name(), traversal.name, visible, rays.size(), different, wrong);
        CHECK(visible > rays.size() / 100);
        CHECK(visible < rays.size() / 100 * 99);
        CHECK(unknown == 0);
        CHECK(different <= kMostJudged);
        CHECK(wrong == 0);
      });
}

}  // namespace

TEST_CASE("closest hits in a generated mesh are Embree's") {
  const Scene scene = test::knotInBox();
  compareClosestHits("knot in a box", scene, test::raysIn(test::boundsOf(scene), kRays));
}

TEST_CASE("closest hits from far away are Embree's") {
  const Scene scene = test::knotInBox();
  compareClosestHits("knot in a far box", scene,
                     test::raysFromAfar(test::boundsOf(scene), kRays / 4));
}

TEST_CASE("closest hits in the reference scene are Embree's") {
  if (const auto scene = test::referenceKnot())
    compareClosestHits("reference knot", *scene, test::raysIn(test::boundsOf(*scene), kRays));
}

TEST_CASE("visibility in a generated mesh is Embree's") {
  compareVisibility("knot in a box", test::knotInBox());
}
