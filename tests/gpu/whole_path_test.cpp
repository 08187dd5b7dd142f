// A path in one shader and one pass per bounce are the same light transport.
#include "renderer/bench/whole_path.h"

#include <catch2/catch.hpp>

#include "renderer/bench/bench_mesh.h"
#include "renderer/bench/picture_agreement.h"
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

std::vector<Vec4> drawPasses(PathTracer& tracer) {
  tracer.resize(kSide, kSide);
  while (tracer.samples() < kSamples) tracer.drawTile(kSide * kSide);
  return tracer.film().mean.front().readFloats();
}

std::vector<Vec4> drawWholePaths(const TestContext& context, const Scene& scene,
                                 const SceneTextures& textures, int bounces, PathForm form) {
  WholePathTracer tracer(context.device(), scene, textures, settingsFor(bounces), form);
  tracer.resize(kSide, kSide);
  for (int i = 0; i < kSamples; ++i) tracer.drawSample();
  return tracer.readMean();
}

}  // namespace

TEST_CASE("a whole path in one shader gives the picture of the passes, looped or unrolled") {
  onEveryContext([](const TestContext& context) {
    for (const Scene& scene : scenes()) {
      PathTracer passes(context.device(), scene, settingsFor(2));
      const std::vector<Vec4> reference = drawPasses(passes);
      for (const PathForm form : {PathForm::loop, PathForm::unrolled}) {
        INFO(context.name() << ", " << scene.name << ", form " << static_cast<int>(form));
        const PictureAgreement same = comparePictures(
            drawWholePaths(context, scene, passes.scene(), 2, form), reference, kSamples);
        CHECK(same.agrees);
        CHECK(same.lost == 0);
      }
    }
  });
}

TEST_CASE("a whole path with one bounce less is told from the passes") {
  const TestContext& context = contexts().front();
  context.makeCurrent();
  const Scene scene = makeBenchBox();
  PathTracer passes(context.device(), scene, settingsFor(2));
  const std::vector<Vec4> reference = drawPasses(passes);
  CHECK_FALSE(comparePictures(drawWholePaths(context, scene, passes.scene(), 1, PathForm::loop),
                              reference, kSamples)
                  .agrees);
}
