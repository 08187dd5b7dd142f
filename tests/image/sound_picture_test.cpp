// Pictures stay sound where a value is not.
#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>

#include "tests/image/pictures.h"
#include "tests/image/scenes.h"

using namespace glimt;
using namespace glimt::test;

TEST_CASE("samples that are not finite are left out of the mean and counted") {
  Scene scene;
  // What this light gives overflows; beside it stands a wall that does not see it.
  addQuad(scene, Vec3(-2, -1, 0), Vec3(2, 0, 0), Vec3(0, 2, 0),
          add(scene, lambert("overflow", Vec3(0), Vec3(3e38f))));
  addQuad(scene, Vec3(0, -1, 0), Vec3(2, 0, 0), Vec3(0, 2, 0),
          add(scene, lambert("wall", Vec3(0.5f))));
  scene.environment.color = Vec3(1);
  scene.camera.position = Vec3(0, 0, 2);
  ContextHandle context = createOffscreenContext(Backend::egl, 2);
  Renderer renderer(context, scene, settingsFor(32, 0));
  for (int i = 0; i < 8; ++i) renderer.renderSample();
  const Image image = renderer.radiance();
  CHECK(std::all_of(image.pixels.begin(), image.pixels.end(), [](const Vec3& p) {
    return std::isfinite(p.r) && std::isfinite(p.g) && std::isfinite(p.b);
  }));
  CHECK(renderer.nonfinitePixels() > 0);
  CHECK(renderer.nonfinitePixels() < 32 * 32);
  CHECK(renderer.lastLosses().not_finite == renderer.nonfinitePixels());
  CHECK(renderer.lastLosses().cut_short == 0);
  // Most light samples go to the light that is so bright, so one pixel's mean tells little.
  double wall = 0;
  for (int y = 0; y < 32; ++y)
    for (int x = 17; x < 32; ++x) wall += image.pixels[static_cast<std::size_t>(y * 32 + x)].g;
  CHECK(wall / (32 * 15) == Approx(0.5).epsilon(0.05));
}

TEST_CASE("an empty scene shows the environment, or black") {
  Scene scene;
  scene.environment.color = Vec3(0.25f, 0.5f, 4);
  ContextHandle context = createOffscreenContext(Backend::egl, 2);
  Renderer renderer(context, scene, settingsFor(8, 4));
  renderer.renderSample();
  for (const Vec3& pixel : renderer.radiance().pixels) CHECK(pixel == Vec3(0.25f, 0.5f, 4));
  CHECK(renderer.nonfinitePixels() == 0);
  scene.environment.color = Vec3(0);
  CHECK(meanOf(render(scene, settingsFor(8, 4), 1)) == glm::dvec3(0));
}

TEST_CASE("the display picture is right side up, clipped and sRGB-encoded") {
  Scene scene;
  addQuad(scene, Vec3(-1, 0, 0), Vec3(2, 0, 0), Vec3(0, 1, 0),
          add(scene, lambert("above", Vec3(0), Vec3(0.5f, 2, 0))));
  scene.camera.position = Vec3(0, 0, 1);
  scene.camera.vertical_fov = 60;
  ContextHandle context = createOffscreenContext(Backend::egl, 2);
  Renderer renderer(context, scene, settingsFor(16, 0));
  renderer.renderSample();
  const DisplayImage image = renderer.display(0);
  const auto byte = [&](int x, int y, int c) {
    return int{image.bytes[static_cast<std::size_t>((y * 16 + x) * 3 + c)]};
  };
  CHECK(byte(8, 2, 0) == 188);  // 0.5 in sRGB
  CHECK(byte(8, 2, 1) == 255);
  CHECK(byte(8, 2, 2) == 0);
  CHECK(byte(8, 13, 0) == 0);
  const DisplayImage brighter = renderer.display(1);
  CHECK(int{brighter.bytes[static_cast<std::size_t>((2 * 16 + 8) * 3)]} == 255);
}
