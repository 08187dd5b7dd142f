// Lights that are very small, very bright, very many, very close, or not there.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <catch2/catch.hpp>
#include <cmath>

#include "tests/hard/bsdfs.h"
#include "tests/hard/hard_case.h"
#include "tests/hard/hard_picture.h"
#include "tests/image/pictures.h"

using namespace glimt;
using namespace glimt::test;

namespace {

const double kPi = std::acos(-1.0);
constexpr float kAlbedo = 0.6f;

const std::array kDimLamps{Vec3(1.5f, 1, -0.5f), Vec3(1.5f, 1, 0.5f), Vec3(2.5f, 1, -0.5f),
                           Vec3(2.5f, 1, 0.5f)};

Material lamp(float radiance) {
  Material material = lambert("lamp", Vec3(0), Vec3(radiance));
  material.double_sided = false;
  return material;
}

// A square that shines down on the floor, around `center`.
void addLamp(Scene& scene, const Vec3& center, float half_width, std::uint32_t material) {
  addQuad(scene, center - Vec3(half_width, 0, half_width), Vec3(2 * half_width, 0, 0),
          Vec3(0, 0, 2 * half_width), material);
}

std::vector<glm::dvec3> square(const glm::dvec3& center, double half_width) {
  const double h = half_width;
  return {center + glm::dvec3(-h, 0, -h), center + glm::dvec3(h, 0, -h),
          center + glm::dvec3(h, 0, h), center + glm::dvec3(-h, 0, h)};
}

double floorRadiance(const std::vector<glm::dvec3>& light, const glm::dvec3& at, double radiance) {
  return kAlbedo / kPi * polygonIrradiance(light, at, glm::dvec3(0, 1, 0), radiance);
}

Scene floorOnly() {
  Scene scene;
  addQuad(scene, Vec3(-5, 0, 5), Vec3(10, 0, 0), Vec3(0, 0, -10),
          add(scene, kBsdfs[0].material(kAlbedo, 0)));
  lookAtSpot(scene, Vec3(3, 1, 0), Vec3(0));
  return scene;
}

Image spot(const Scene& scene, int bounces, int samples = slowDriver() ? 64 : 256) {
  return hardPicture(scene, settingsFor(16, bounces), samples);
}

// A wall at x = 0 that no light passes, and four lamps on this side of it.
Scene lampsBesideWall() {
  Scene scene = floorOnly();
  addQuad(scene, Vec3(0, -1, -50), Vec3(0, 0, 100), Vec3(0, 50, 0),
          add(scene, lambert("wall", Vec3(0))));
  const std::uint32_t dim = add(scene, lamp(1));
  for (const Vec3& center : kDimLamps) addLamp(scene, center, 0.25f, dim);
  lookAtSpot(scene, Vec3(3.8f, 0.9f, 0), Vec3(2, 0, 0));
  return scene;
}

void checkLampsAreSeen(const Scene& scene, const std::string& name, double bound) {
  double expected = 0;
  for (const Vec3& center : kDimLamps)
    expected += floorRadiance(square(glm::dvec3(center), 0.25), glm::dvec3(2, 0, 0), 1);
  for (const int bounces : {0, 2})
    checkAtMost(
        "light", fmt::format("{}, {} bounces", name, bounces),
        "mean of a spot under lamps beside it, relative error",
        relativeError(meanRadiance(spot(scene, bounces, slowDriver() ? 256 : 1024)), expected),
        bound);
}

// Pixels that are not exactly black.
int litPixels(const Image& image) {
  return static_cast<int>(std::count_if(image.pixels.begin(), image.pixels.end(),
                                        [](const Vec3& pixel) { return pixel != Vec3(0); }));
}

}  // namespace

TEST_CASE("a light of 1e-8 square metres lights like a point of the same power") {
  const double power = 100;  // a lamp's, in watts
  const double area = 1e-8;
  Scene scene = floorOnly();
  addLamp(scene, Vec3(1, 2, 0), 0.5e-4f,
          add(scene, lamp(static_cast<float>(power / (kPi * area)))));
  const double distance = std::sqrt(5.0);
  const double cosine = 2 / distance;
  const double intensity = power / kPi * cosine;  // of a surface that radiates by the cosine
  const double expected = kAlbedo / kPi * intensity * cosine / (distance * distance);
  const Image image = spot(scene, 1);
  checkAtMost("light", "light of 1e-8 square metres, 100 W", "mean against a point light, relative",
              relativeError(meanRadiance(image), expected), 0.005);
  checkAtMost("light", "light of 1e-8 square metres, 100 W",
              "brightest pixel, of the point light's", brightest(image) / expected, 1.02);
}

TEST_CASE("a light a million times brighter than another does not put it out") {
  Scene scene = floorOnly();
  const std::uint32_t bright = add(scene, lamp(1e6f));
  const std::uint32_t dim = add(scene, lamp(1));
  addLamp(scene, Vec3(-2, 1, 0), 0.5f, bright);
  addLamp(scene, Vec3(2, 1, 0), 0.5f, dim);
  addQuad(scene, Vec3(0, -1, -50), Vec3(0, 0, 100), Vec3(0, 50, 0),
          add(scene, lambert("wall", Vec3(0))));
  const std::string what = "mean of a spot under it, relative error";
  for (const bool on_dim_side : {false, true}) {
    const float x = on_dim_side ? 2.0f : -2.0f;
    lookAtSpot(scene, Vec3(1.9f * x, 0.9f, 0), Vec3(x, 0, 0));
    const double expected =
        floorRadiance(square(glm::dvec3(x, 1, 0), 0.5), glm::dvec3(x, 0, 0), on_dim_side ? 1 : 1e6);
    for (const int bounces : {0, 2})
      checkAtMost("light",
                  fmt::format("two lights, 1 to 1e6, {} bounces: the {}", bounces,
                              on_dim_side ? "dim one" : "bright one"),
                  what, relativeError(meanRadiance(spot(scene, bounces)), expected), 0.02);
  }
}

TEST_CASE("a lamp a million times brighter behind a wall does not put out many") {
  Scene scene = lampsBesideWall();
  addLamp(scene, Vec3(-2, 1, 0), 0.5f, add(scene, lamp(1e6f)));
  checkLampsAreSeen(scene, "a lamp of 1e6 behind a wall", 0.05);
}

TEST_CASE("a sun behind a wall does not put out lamps") {
  Scene scene = lampsBesideWall();
  PunctualLight sun;
  sun.kind = PunctualLight::Kind::directional;
  sun.direction = glm::normalize(Vec3(1, -1, 0));
  sun.intensity = Vec3(1e6f);
  scene.lights.push_back(sun);
  checkLampsAreSeen(scene, "a sun of 1e6 behind a wall", 0.002);
}

TEST_CASE("a sky's sun behind a wall does not put out lamps") {
  Scene scene = lampsBesideWall();
  scene.environment.color = Vec3(1);
  scene.environment.image = {32, 16, std::vector<Vec3>(32 * 16, Vec3(0))};
  scene.environment.image.pixels[4 * 32] = Vec3(1e6f);  // towards -x, half way up
  checkLampsAreSeen(scene, "a sky with a sun of 1e6 behind a wall", 0.002);
}

TEST_CASE("chrome that the last bounce meets gives no fireflies") {
  Scene scene = floorOnly();
  addLamp(scene, Vec3(0, 4, 3), 1, add(scene, lamp(10)));
  Material chrome = lambert("chrome", Vec3(0.9f));
  chrome.metallic = 1;
  chrome.roughness = 0.06f;
  addQuad(scene, Vec3(-3, 0, -2), Vec3(6, 0, 0), Vec3(0, 4, 0), add(scene, chrome));
  const Image image = spot(scene, 1, 256);
  checkAtMost("light", "a floor beside chrome, one bounce",
              "brightest pixel of a spot, of its mean", brightest(image) / meanRadiance(image),
              1.5);
}

TEST_CASE("ten thousand lights light like one of their area") {
  Scene scene = floorOnly();
  const std::uint32_t material = add(scene, lamp(10));
  for (int i = 0; i < 100; ++i)
    for (int k = 0; k < 100; ++k)
      addLamp(
          scene,
          Vec3(static_cast<float>(i - 50) + 0.5f, 100, static_cast<float>(k - 50) + 0.5f) * 0.01f,
          0.005f, material);
  const double expected = floorRadiance(square(glm::dvec3(0, 1, 0), 0.5), glm::dvec3(0), 10);
  checkAtMost("light", "10,000 lights side by side", "mean against one light, relative",
              relativeError(meanRadiance(spot(scene, 0)), expected), 0.005);
}

TEST_CASE("a light that touches the wall it lights gives no fireflies") {
  Scene scene;
  addQuad(scene, Vec3(-1, 0, 0), Vec3(2, 0, 0), Vec3(0, 2, 0),
          add(scene, kBsdfs[0].material(kAlbedo, 0)));  // the wall, z = 0
  addQuad(scene, Vec3(-0.5f, 1, 0), Vec3(1, 0, 0), Vec3(0, 0, 1), add(scene, lamp(1)));  // down
  scene.camera.position = Vec3(0, 0.9f, 2);
  scene.camera.target = Vec3(0, 0.9f, 0);
  scene.camera.vertical_fov = 5;
  const RenderSettings settings = settingsFor(16, 1);
  const int samples = slowDriver() ? 256 : 1024;
  const Image image = hardPicture(scene, settings, samples);

  // Each pixel's mean irradiance, by points within it.
  const std::vector<glm::dvec3> light{{-0.5, 1, 0}, {0.5, 1, 0}, {0.5, 1, 1}, {-0.5, 1, 1}};
  const double height = 2 * 2 * std::tan(2.5 * kPi / 180);
  double expected = 0;
  constexpr int kPoints = 64;
  for (int i = 0; i < kPoints * kPoints; ++i) {
    const glm::dvec3 at(((i % kPoints + 0.5) / kPoints - 0.5) * height,
                        0.9 + ((i / kPoints + 0.5) / kPoints - 0.5) * height, 0);
    expected +=
        kAlbedo / kPi * polygonIrradiance(light, at, glm::dvec3(0, 0, 1), 1) / (kPoints * kPoints);
  }
  checkAtMost("light", "light that touches a wall", "mean against the form factor, relative",
              relativeError(meanRadiance(image), expected), 0.01);

  // Up to the edge: nothing is brighter than a surface in the middle of the light.
  scene.camera.position = Vec3(0, 0.999f, 2);
  scene.camera.target = Vec3(0, 0.999f, 0);
  scene.camera.vertical_fov = 0.02f;
  checkAtMost("light", "light that touches a wall",
              "brightest pixel at the edge, of the most there can be",
              brightest(hardPicture(scene, settings, samples)) / kAlbedo, 1);
}

TEST_CASE("without light the picture is black, exactly") {
  Scene scene = floorOnly();
  addSphere(scene, 1, 2, 0);
  scene.camera.vertical_fov = 60;
  scene.environment.color = Vec3(0);
  checkAtMost("light", "no light, black environment", "pixels that are not 0",
              litPixels(spot(scene, 4, 8)), 0);
  scene.environment.color = Vec3(1);
  scene.environment.strength = 0;
  checkAtMost("light", "no light, environment of strength 0", "pixels that are not 0",
              litPixels(spot(scene, 4, 8)), 0);
  scene.materials[0] = lambert("black", Vec3(0));
  scene.environment = Environment();
  addLamp(scene, Vec3(0, 3, 0), 0.1f, add(scene, lamp(1e6f)));
  checkAtMost("light", "bright light on black surfaces", "pixels that are not 0",
              litPixels(spot(scene, 4, 8)), 0);
}
