// A sample ends when no path of it is alive, and not before.
#include <algorithm>
#include <catch2/catch.hpp>

#include "renderer/bench/bench_mesh.h"
#include "renderer/gl/query.h"
#include "renderer/passes/path_tracer.h"
#include "tests/gpu/contexts.h"
#include "tests/image/scenes.h"

using namespace glimt;
using namespace glimt::test;

namespace {

constexpr int kSide = 48;
constexpr int kBounces = 20;

// Beside a lamp, so that light is looked for wherever a path may be.
Scene litScene(const Vec3& target) {
  Scene scene;
  const std::uint32_t white = add(scene, lambert("white", Vec3(0.8f)));
  const std::uint32_t lamp = add(scene, lambert("lamp", Vec3(0.8f), Vec3(20)));
  addQuad(scene, {-1, -1, 0}, {2, 0, 0}, {0, 2, 0}, white);
  addQuad(scene, {-0.05f, -0.05f, 1}, {0, 0.1f, 0}, {0.1f, 0, 0}, lamp);
  scene.camera.position = {0, 0, 4};
  scene.camera.target = target;
  return scene;
}

PathTracer tracerOf(const TestContext& context, const Scene& scene, bool live_only) {
  PathTracerSettings settings;
  settings.bounces = kBounces;
  settings.live_only = live_only;
  PathTracer tracer(context.device(), scene, settings);
  tracer.resize(kSide, kSide);
  return tracer;
}

int drawsOfSample(PathTracer& tracer) {
  const int before = tracer.samples();
  int draws = 0;
  for (; tracer.samples() == before; ++draws) tracer.drawTile(kSide * kSide);
  return draws;
}

}  // namespace

TEST_CASE("a sample whose paths all leave at once is drawn without the bounces that follow") {
  onEveryContext([](const TestContext& context) {
    CAPTURE(context.name());
    REQUIRE(canDrawLiveOnly(context.device()));
    PathTracer away = tracerOf(context, litScene({0, 0, 9}), true);
    for (int sample = 0; sample < 3; ++sample) CHECK(drawsOfSample(away) < 8);
    PathTracer closed = tracerOf(context, makeBenchBox(), true);
    for (int sample = 0; sample < 3; ++sample) CHECK(drawsOfSample(closed) > 2 * kBounces);
  });
}

TEST_CASE("where few paths go on, a sample ends behind the last of them, each in its own place") {
  onEveryContext([](const TestContext& context) {
    CAPTURE(context.name());
    // Nearly all paths leave at the white square; few come upon the lamp above it.
    const Scene scene = litScene({0, 0, 0});
    PathTracer limited = tracerOf(context, scene, true);
    PathTracer whole = tracerOf(context, scene, false);
    CHECK(drawsOfSample(limited) < kBounces);
    drawsOfSample(whole);
    int least = 3 * kBounces;
    int most = 0;
    for (int sample = 1; sample < 24; ++sample) {
      const int draws = drawsOfSample(limited);
      least = std::min(least, draws);
      most = std::max(most, draws);
      CHECK(drawsOfSample(whole) > 2 * kBounces);
    }
    CHECK(limited.accumulation().readMean() == whole.accumulation().readMean());
    if (!gl::Query(context.gl())) return;  // later samples cannot be known to have ended
    CHECK(least < most);
    CHECK(most < 2 * kBounces);
  });
}
