// The wide record is the yardstick of the packed one: both give the same picture within its noise.
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <iostream>

#include "renderer/core/error.h"
#include "tests/image/pictures.h"
#include "tests/image/scenes.h"

using namespace glimt;
using namespace glimt::test;

namespace {

// A room with a coloured ball in it, open to a sky on one side: paths meet lights, surfaces and the
// outside.
Scene openRoom() {
  Scene scene;
  const std::uint32_t white = add(scene, lambert("white", Vec3(0.8f)));
  addQuad(scene, {-2, -1, 2}, {4, 0, 0}, {0, 0, -4}, white);
  addQuad(scene, {-2, -1, -2}, {4, 0, 0}, {0, 4, 0}, white);
  addQuad(scene, {-2, -1, 2}, {0, 0, -4}, {0, 4, 0}, add(scene, lambert("red", {0.7f, 0.1f, 0})));
  addQuad(scene, {-0.5f, 2.5f, -0.5f}, {1, 0, 0}, {0, 0, 1},
          add(scene, lambert("lamp", Vec3(0), Vec3(9, 7, 5))));
  addSphere(scene, 1, 2, add(scene, lambert("ball", {0.3f, 0.6f, 0.9f})));
  scene.environment.color = Vec3(0.1f, 0.2f, 0.3f);
  scene.camera.position = {0, 1, 6};
  return scene;
}

struct Render {
  Image image;
  RenderStatistics statistics;
};

Render renderWith(const std::string& record, int samples) {
  ContextHandle context = createOffscreenContext(Backend::egl, 3);
  RenderSettings settings = settingsFor(48, 4);
  settings.record = record;
  Renderer renderer(context, openRoom(), settings);
  for (int i = 0; i < samples; ++i) renderer.renderSample();
  return {renderer.radiance(), renderer.statistics()};
}

}  // namespace

TEST_CASE("packed and wide records give the same picture, within the noise of their difference") {
  const Render packed = renderWith("packed", 64);
  const Render wide = renderWith("wide", 64);
  CHECK_FALSE(identical(packed.image, wide.image));
  glm::dvec3 sum(0), squares(0), light(0);
  for (std::size_t i = 0; i < wide.image.pixels.size(); ++i) {
    const glm::dvec3 w(wide.image.pixels[i]);
    const glm::dvec3 d = glm::dvec3(packed.image.pixels[i]) - w;
    sum += d;
    squares += d * d;
    light += w;
  }
  for (int channel = 0; channel < 3; ++channel) {
    const double deviation = std::sqrt(squares[channel]);  // of the sum, for independent pixels
    std::cout << "channel " << channel << ": mean off by " << 100 * sum[channel] / light[channel]
              << "%, standard deviation " << 100 * deviation / light[channel] << "%\n";
    CHECK(std::abs(sum[channel]) < 4 * deviation);
    CHECK(4 * deviation < 0.001 * light[channel]);  // or the line above says little
  }
}

TEST_CASE("packed and wide records count the same rays, but for paths at edges") {
  const RenderStatistics packed = renderWith("packed", 1).statistics;
  const RenderStatistics wide = renderWith("wide", 1).statistics;
  CHECK(wide.camera_rays == packed.camera_rays);
  CHECK(wide.bounce_rays == Approx(packed.bounce_rays).epsilon(0.01));
  CHECK(wide.shadow_rays == Approx(packed.shadow_rays).epsilon(0.01));
}

TEST_CASE("the wide record is refused in a context of ES 2.0, with what to do") {
  ContextHandle context = createOffscreenContext(Backend::egl, 2);
  RenderSettings settings = settingsFor(16, 1);
  settings.record = "wide";
  try {
    const Renderer renderer(context, openRoom(), settings);
    FAIL("it was not refused");
  } catch (const Error& error) {
    CHECK(error.kind() == ErrorKind::usage);
    CHECK(error.what() == std::string("record 'wide' needs OpenGL ES 3.0; render with --gles 3"));
  }
}

TEST_CASE("a record that does not exist is refused, with those that do") {
  ContextHandle context = createOffscreenContext(Backend::egl, 2);
  RenderSettings settings = settingsFor(16, 1);
  settings.record = "tiny";
  CHECK_THROWS_WITH(Renderer(context, openRoom(), settings), Catch::Contains("packed, wide"));
}
