// A path in one shader and one pass per bounce are the same light transport.
#include "renderer/bench/whole_path.h"

#include <catch2/catch.hpp>

#include "renderer/bench/bench_mesh.h"
#include "renderer/bench/picture_comparison.h"
#include "tests/gpu/contexts.h"

using namespace glimt;
using namespace glimt::test;

namespace {

constexpr int kSide = 32;
constexpr int kSamples = 32;

// Closed, with light from triangles only; and open, with light from everywhere.
std::vector<Scene> scenes() {
  std::vector<Scene> scenes{makeBenchBox(), makeBenchMesh(600)};
  scenes.back().environment.color = {0.3f, 0.4f, 0.6f};
  return scenes;
}

PathTracerSettings settingsFor(int bounces) {
  PathTracerSettings settings;
  settings.bounces = bounces;
  settings.traversal = "skip";
  return settings;
}

// Of whole paths with `bounces` with passes of two.
PictureComparison compare(const TestContext& context, const Scene& scene, PathForm form,
                          int bounces = 2) {
  PathTracer passes(context.device(), scene, settingsFor(2));
  WholePathTracer whole(context.device(), scene, passes.scene(), settingsFor(bounces), form);
  passes.resize(kSide, kSide);
  whole.resize(kSide, kSide);
  PictureComparison comparison;
  for (int sample = 1; sample <= kSamples; ++sample) {
    while (passes.samples() < sample) passes.drawTile(kSide * kSide);
    whole.drawSample();
    comparison.add(whole.readRadiance(), passes.film().radiance.front().readFloats());
  }
  return comparison;
}

}  // namespace

TEST_CASE("a whole path in one shader gives the picture of the passes, looped or unrolled") {
  onEveryContext([](const TestContext& context) {
    for (const Scene& scene : scenes())
      for (const PathForm form : {PathForm::loop, PathForm::unrolled}) {
        INFO(context.name() << ", " << scene.name << ", form " << static_cast<int>(form));
        const PictureComparison comparison = compare(context, scene, form);
        CHECK(comparison.agrees());
        CHECK(comparison.lost() == 0);
      }
  });
}

TEST_CASE("a whole path with one bounce less is told from the passes") {
  contexts().front().makeCurrent();
  CHECK_FALSE(compare(contexts().front(), makeBenchBox(), PathForm::loop, 1).agrees());
}
