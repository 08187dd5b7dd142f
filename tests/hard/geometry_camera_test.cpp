// Cameras where one would not put them, and pictures of shapes that one would not ask for.
#include <fmt/format.h>

#include <catch2/catch.hpp>
#include <cmath>

#include "tests/hard/geometry_pictures.h"
#include "tests/hard/geometry_scenes.h"
#include "tests/hard/hard_case.h"
#include "tests/image/scenes.h"

using namespace glimt;
using namespace glimt::test;

namespace {

constexpr int kBounces = 3;

// Of a picture in the closed cube of tests/image/scenes.h, half of whose light is reflected: what
// its mean is off what it has to be, relative.
double furnaceError(const Vec3& position, const Vec3& target, float vertical_fov = 80) {
  Scene scene = furnace(0.5f);
  scene.camera.position = position;
  scene.camera.target = target;
  scene.camera.vertical_fov = vertical_fov;
  const Image image = hardPicture(scene, slowDriver() ? 8 : 48, kBounces, slowDriver() ? 8 : 64);
  return std::abs(brightnessOf(image) / furnaceRadiance(0.5, kBounces) - 1);
}

// Three standard errors of 147,000 samples, or 4,096 on slow drivers, that are off by half the
// mean.
double bound() {
  return slowDriver() ? 0.066 : 0.004;
}

Scene ball() {
  Scene scene;
  addSphere(scene, 1, 3, add(scene, lambert("ball", Vec3(0.8f))));
  scene.environment.color = Vec3(1);
  return scene;
}

}  // namespace

TEST_CASE("a camera in, on and close to a wall sees what is before it") {
  const std::string what = "mean, relative to what it has to be";
  const Vec3 middle(0.1f, 0.05f, 0);
  checkAtMost("geometry", "camera in a closed cube", what,
              furnaceError(Vec3(0.3f, -0.2f, 0.9f), middle), bound());
  checkAtMost("geometry", "camera on a wall", what, furnaceError(Vec3(0.3f, -0.2f, 1), middle),
              bound());
  checkAtMost("geometry", "camera in a corner", what, furnaceError(Vec3(1), middle, 30), bound());
  checkAtMost("geometry", "camera 1e-6 before a wall", what,
              furnaceError(Vec3(0.3f, -0.2f, 1 - 1e-6f), middle), bound());
  checkAtMost("geometry", "camera 1e-6 before a wall that it looks at", what,
              furnaceError(Vec3(0.3f, -0.2f, 1 - 1e-6f), Vec3(0.3f, -0.2f, 2)), bound());
}

TEST_CASE("the narrowest and the widest views show what is there") {
  Scene scene = ball();
  scene.camera.position = Vec3(0, 0, 3);
  scene.camera.vertical_fov = 0.01f;
  checkAtMost(
      "geometry", "field of view of 0.01 degrees", "mean difference from the albedo, relative",
      std::abs(brightnessOf(hardPicture(scene, slowDriver() ? 8 : 48, 1, slowDriver() ? 4 : 16)) /
                   0.8 -
               1),
      0.002);

  // The ball covers a disk of radius tan(asin(1 / 3)) in a square of half side tan(85 degrees).
  const double disk = std::acos(-1.0) / 8 / std::pow(2 * std::tan(std::acos(-1.0) * 85 / 180), 2);
  scene.camera.vertical_fov = 170;
  // A hundred rays meet it: fewer would not do, on whatever driver.
  const double mean = brightnessOf(hardPicture(scene, 48, 1, 64));
  checkAtMost("geometry", "field of view of 170 degrees", "what the ball takes, relative",
              std::abs((1 - mean) / (0.2 * disk) - 1), 0.1);
}

TEST_CASE("a camera that looks along its up sees what is there") {
  for (const float way : {1.0f, -1.0f}) {
    Scene scene = ball();
    scene.camera.position = Vec3(0, -3 * way, 0);
    scene.camera.vertical_fov = 20;
    const Image image = hardPicture(scene, slowDriver() ? 8 : 32, 1, slowDriver() ? 4 : 16);
    checkAtMost("geometry", way > 0 ? "looking straight up" : "looking straight down",
                "mean difference from the albedo, relative",
                std::abs(brightnessOf(image) / 0.8 - 1), 0.002);
  }
}

TEST_CASE("one triangle, and none") {
  Scene scene;
  scene.environment.color = Vec3(0.25f, 0.5f, 4);
  checkAtMost("geometry", "no triangle", "pixels that are not the environment",
              pixelsOtherThan(hardPicture(scene, 16, 4, 4), scene.environment.color), 0);
  addTriangle(scene, Vec3(-9, -9, 0), Vec3(9, -9, 0), Vec3(0, 9, 0),
              add(scene, lambert("one", Vec3(0.8f))));
  scene.environment.color = Vec3(1);
  const Image image = hardPicture(scene, 16, 4, 16);
  checkAtMost("geometry", "one triangle", "mean difference from its albedo, relative",
              std::abs(brightnessOf(image) / 0.8 - 1), 0.002);
}

TEST_CASE("pictures of any shape show the same scene") {
  struct Shape {
    int width, height;
  };
  Scene scene = ball();
  scene.camera.position = Vec3(0, 0, 3);
  scene.camera.vertical_fov = 1;
  for (const Shape& shape : {Shape{1, 1}, Shape{1, 1000}, Shape{30, 20}}) {
    const Image image = hardPicture(scene, shape.width, shape.height, 1, 16);
    checkAtMost("geometry", fmt::format("{} x {} pixels", shape.width, shape.height),
                "mean difference from the albedo, relative",
                std::abs(brightnessOf(image) / 0.8 - 1),
                shape.width * shape.height > 1 ? 0.002 : 0.02);
  }
  // 4097 pixels by 3 see the disk of the ball in a strip that is 1366 times as wide as high.
  scene.camera.vertical_fov = 0.05f;
  const Image image = hardPicture(scene, 4097, 3, 1, slowDriver() ? 2 : 16);
  const Image middle{1, 1, {image.pixels[4097 + 2048]}};
  CHECK(image.pixels.size() == 4097 * 3);
  checkAtMost("geometry", "4097 x 3 pixels", "its middle, relative to the albedo",
              std::abs(brightnessOf(middle) / 0.8 - 1), 0.05);
  const double half_width = 4097.0 / 3 * std::tan(std::acos(-1.0) * 0.025 / 180);
  const double covered = std::sqrt(1.0 / 8) / half_width;
  checkAtMost("geometry", "4097 x 3 pixels", "what the ball takes, relative",
              std::abs((1 - brightnessOf(image)) / (0.2 * covered) - 1), 0.02);
}
