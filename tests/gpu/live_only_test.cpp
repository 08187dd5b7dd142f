// Drawing the passes for live paths only changes the time they take, and not the picture.
#include <algorithm>
#include <catch2/catch.hpp>

#include "renderer/passes/path_tracer.h"
#include "tests/gpu/contexts.h"
#include "tests/image/scenes.h"

using namespace glimt;
using namespace glimt::test;

namespace {

constexpr int kWidth = 48;
constexpr int kHeight = 32;

// A floor that leaves a part of the picture free, a slanted sheet above it, and a lamp.
Scene openScene(Vec3 environment) {
  Scene scene;
  const std::uint32_t white = add(scene, lambert("white", Vec3(0.8f)));
  const std::uint32_t lamp = add(scene, lambert("lamp", Vec3(0.8f), Vec3(20)));
  addQuad(scene, {-3, 0, -3}, {6, 0, 0}, {0, 0, 6}, white);
  addQuad(scene, {-1, 0, -1}, {2, 0.2f, 0}, {0, 2, 1}, white);
  addQuad(scene, {-0.5f, 3, 0}, {1, 0, 0}, {0, 0, 0.5f}, lamp);
  scene.environment.color = environment;
  scene.camera.position = {0, 1.5f, 8};
  scene.camera.target = {0, 1, 0};
  return scene;
}

std::vector<Vec4> picture(const TestContext& context, const Scene& scene, const std::string& record,
                          bool live_only) {
  PathTracerSettings settings;
  settings.record = record;
  settings.live_only = live_only;
  PathTracer tracer(context.device(), scene, settings);
  tracer.resize(kWidth, kHeight);
  while (tracer.samples() < 5) tracer.drawTile(512);
  return tracer.accumulation().readMean();
}

double sumOf(const std::vector<Vec4>& texels) {
  double sum = 0;
  for (const Vec4& texel : texels) sum += texel.x + texel.y + texel.z;
  return sum;
}

}  // namespace

TEST_CASE("passes for live paths only give the same picture, bit for bit") {
  onEveryContext([](const TestContext& context) {
    CAPTURE(context.name());
    CHECK(canDrawLiveOnly(context.device()));  // or there is nothing to compare
    for (const Record& record : records()) {
      if (record.gles > context.gles()) continue;
      for (const float sky : {0.0f, 0.7f}) {
        CAPTURE(record.name, sky);
        const Scene scene = openScene(Vec3(sky));
        const std::vector<Vec4> limited = picture(context, scene, record.name, true);
        CHECK(sumOf(limited) > 0);
        CHECK(limited == picture(context, scene, record.name, false));
      }
    }
  });
}
