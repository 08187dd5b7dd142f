// Transparent backgrounds, and the shadows that a shadow catcher leaves on them.
#include <catch2/catch.hpp>

#include "renderer/scene/effects_of.h"
#include "tests/image/pictures.h"
#include "tests/image/scenes.h"

using namespace glimt;
using namespace glimt::test;

namespace {

constexpr int kSide = 16;

std::size_t at(int x, int y) {
  return static_cast<std::size_t>(y) * kSide + static_cast<std::size_t>(x);
}

// An even sky over a floor that is wider than the picture, looked at from above.
Scene floorUnderSky(bool catcher) {
  Scene scene;
  Material floor = lambert("floor", Vec3(0.5f));
  floor.shadow_catcher = catcher;
  addQuad(scene, Vec3(-1e3f, 0, 1e3f), Vec3(2e3f, 0, 0), Vec3(0, 0, -2e3f), add(scene, floor));
  scene.environment.color = Vec3(1);
  scene.camera.position = Vec3(0, 3, 0);
  scene.camera.up = Vec3(0, 0, -1);
  scene.transparent_background = true;
  return scene;
}

// The left half of the picture.
void addCard(Scene& scene, float z) {
  addQuad(scene, Vec3(-4, -4, z), Vec3(4, 0, 0), Vec3(0, 8, 0),
          add(scene, lambert("card", Vec3(0.7f, 0.5f, 0.3f))));
}

}  // namespace

TEST_CASE("a transparent background has no light and no alpha, and what covers it all of both") {
  Scene scene;
  addCard(scene, 0);
  scene.environment.color = Vec3(0.5f, 1, 2);
  scene.camera.position = Vec3(0, 0, 4);
  const Image opaque = render(scene, settingsFor(kSide, 2), 8);
  CHECK(opaque.alpha.empty());
  scene.transparent_background = true;
  const Image image = render(scene, settingsFor(kSide, 2), 8);
  REQUIRE(image.alpha.size() == image.pixels.size());
  for (int y = 0; y < kSide; ++y) {
    for (int x = 0; x < kSide; ++x) {
      const bool covered = x < kSide / 2;
      CAPTURE(x, y);
      CHECK(image.alpha[at(x, y)] == (covered ? 1 : 0));
      // To the last bit: only the camera sees it otherwise.
      CHECK(image.pixels[at(x, y)] == (covered ? opaque.pixels[at(x, y)] : Vec3(0)));
    }
  }
}

TEST_CASE("the edge of a surface covers a part of a pixel, and is as bright as that part") {
  Scene scene;
  addCard(scene, 0);
  scene.environment.color = Vec3(1);
  scene.camera.position = Vec3(0.07f, 0, 4);
  scene.camera.target = Vec3(0.07f, 0, 0);
  scene.transparent_background = true;
  const Image image = render(scene, settingsFor(kSide, 0), 64);
  const float alpha = image.alpha[at(kSide / 2 - 1, kSide / 2)];
  CHECK(alpha > 0.1f);
  CHECK(alpha < 0.9f);
  // The card reflects all of its colour: no light is missing from half of the even sky.
  CHECK(image.pixels[at(kSide / 2 - 1, kSide / 2)].r / alpha == Approx(0.7f).epsilon(0.03));
}

TEST_CASE("a shadow catcher without a shadow is not there") {
  const Image image = render(floorUnderSky(true), settingsFor(kSide, 2), 8);
  for (const float alpha : image.alpha) CHECK(alpha == 0);
  for (const Vec3& pixel : image.pixels) CHECK(pixel == Vec3(0));
}

TEST_CASE("beside a wall without end a shadow catcher is dark by half") {
  Scene scene = floorUnderSky(true);
  addQuad(scene, Vec3(0, 0, -1e3f), Vec3(0, 0, 2e3f), Vec3(0, 1e3f, 0),
          add(scene, lambert("wall", Vec3(0))));
  scene.camera.position = Vec3(-0.5f, 0.5f, 0);
  scene.camera.target = Vec3(-0.5f, 0, 0);
  scene.camera.vertical_fov = 20;
  const Image image = render(scene, settingsFor(kSide, 2), 64);
  float mean = 0;
  for (const float alpha : image.alpha) mean += alpha / static_cast<float>(image.alpha.size());
  CHECK(mean == Approx(0.5f).margin(0.01));
}

TEST_CASE("a point's shadow on a shadow catcher is whole, and black") {
  Scene scene = floorUnderSky(true);
  scene.environment = Environment();
  PunctualLight light;
  light.position = Vec3(0, 2, 0);
  light.intensity = Vec3(5);
  scene.lights.push_back(light);
  // Beside the view, so that the camera sees the shadow and not what throws it.
  addQuad(scene, Vec3(-5, 1, 5), Vec3(5, 0, 0), Vec3(0, 0, -10),
          add(scene, lambert("card", Vec3(0.5f))));
  scene.camera.position = Vec3(0, 0.9f, 0);
  scene.camera.target = Vec3(0, 0, 0);
  const Image image = render(scene, settingsFor(kSide, 2), 8);
  CHECK(image.alpha[at(2, 8)] == 1);
  CHECK(image.pixels[at(2, 8)] == Vec3(0));
  CHECK(image.alpha[at(13, 8)] == 0);
}

TEST_CASE("what a shadow catcher reflects lights other surfaces as that of any floor does") {
  const auto ball = [](bool catcher) {
    Scene scene = floorUnderSky(catcher);
    const std::size_t first = scene.positions.size();
    addSphere(scene, 0.8f, 2, add(scene, lambert("ball", Vec3(0.8f))));
    for (std::size_t i = first; i < scene.positions.size(); ++i) scene.positions[i].y += 0.8f;
    return render(scene, settingsFor(kSide, 3), 8);
  };
  const Image floor = ball(false);
  const Image caught = ball(true);
  CHECK(floor.alpha[at(0, 0)] == 1);
  CHECK(caught.alpha[at(0, 0)] < 1);
  CHECK(caught.pixels[at(8, 8)] == floor.pixels[at(8, 8)]);
}

TEST_CASE("a catcher is a floor like any other where the background is not transparent") {
  Scene scene = floorUnderSky(true);
  scene.transparent_background = false;
  CHECK_FALSE(has(effectsOf(scene), Effect::shadow_catcher));
  const Image image = render(scene, settingsFor(kSide, 2), 4);
  CHECK(image.alpha.empty());
  CHECK(image.pixels[at(8, 8)].r > 0.4f);
}
