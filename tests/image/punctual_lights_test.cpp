// What lights without triangles do to a Lambert floor, from the definitions of their kinds.
#include <catch2/catch.hpp>

#include <cmath>

#include "tests/image/pictures.h"
#include "tests/image/scenes.h"

using namespace glimt;
using namespace glimt::test;

namespace {

constexpr double kPi = 3.14159265358979;
constexpr double kAlbedo = 0.6;

// A floor, and a camera that sees a spot of it a few millimetres wide around the origin.
Scene floorAround() {
  Scene scene;
  addQuad(scene, Vec3(-5, 0, 5), Vec3(10, 0, 0), Vec3(0, 0, -10),
          add(scene, lambert("floor", Vec3(static_cast<float>(kAlbedo)))));
  scene.camera.position = Vec3(0, 1, 3);
  scene.camera.target = Vec3(0);
  scene.camera.vertical_fov = 0.1f;
  return scene;
}

// Of the spot.
double irradiance(const Scene& scene, int samples = 64, int bounces = 0) {
  return meanOf(render(scene, settingsFor(16, bounces), samples)).g * kPi / kAlbedo;
}

PunctualLight pointAt(const Vec3& position, float intensity) {
  PunctualLight light;
  light.position = position;
  light.intensity = Vec3(intensity);
  return light;
}

// Aimed at a place that is `degrees` beside the origin, seen from the light.
PunctualLight spotBeside(double degrees) {
  PunctualLight light = pointAt(Vec3(0, 2, 0), 10);
  light.kind = PunctualLight::Kind::spot;
  const double angle = degrees * kPi / 180;
  light.direction = Vec3(glm::dvec3(std::sin(angle), -std::cos(angle), 0));
  light.inner_cone = static_cast<float>(10 * kPi / 180);
  light.outer_cone = static_cast<float>(30 * kPi / 180);
  return light;
}

PunctualLight sun(float irradiance) {
  PunctualLight light;
  light.kind = PunctualLight::Kind::directional;
  light.direction = glm::normalize(Vec3(-1, -2, 0));
  light.intensity = Vec3(irradiance);
  return light;
}

}  // namespace

TEST_CASE("a point lights by the cosine and the inverse square of its distance") {
  Scene scene = floorAround();
  scene.lights = {pointAt(Vec3(1, 2, 0), 10)};
  CHECK(irradiance(scene) == Approx(10 * (2 / std::sqrt(5)) / 5).epsilon(0.003));
}

TEST_CASE("a light's range is a window over the inverse square, and dark from its end on") {
  Scene scene = floorAround();
  scene.lights = {pointAt(Vec3(0, 2, 0), 10)};
  scene.lights[0].range = 3;
  CHECK(irradiance(scene) == Approx(2.5 * (1 - std::pow(2.0 / 3, 4))).epsilon(0.003));
  scene.lights[0].range = 1.99f;
  CHECK(irradiance(scene) == 0);
}

TEST_CASE("a spot is even within its inner cone, dark outside the outer one, smooth between") {
  Scene scene = floorAround();
  const auto cosine = [](double degrees) { return std::cos(degrees * kPi / 180); };
  scene.lights = {spotBeside(8)};
  CHECK(irradiance(scene) == Approx(2.5).epsilon(0.003));
  scene.lights = {spotBeside(20)};
  const double between = (cosine(20) - cosine(30)) / (cosine(10) - cosine(30));
  CHECK(irradiance(scene) == Approx(2.5 * between * between).epsilon(0.003));
  scene.lights = {spotBeside(32)};
  CHECK(irradiance(scene) == 0);
}

TEST_CASE("a directional light has the same irradiance everywhere, by the cosine") {
  Scene scene = floorAround();
  scene.lights = {sun(3)};
  CHECK(irradiance(scene) == Approx(3 * 2 / std::sqrt(5)).epsilon(0.003));
}

TEST_CASE("what is between a surface and a light of any kind is in shadow, exactly") {
  Scene scene = floorAround();
  const bool blocked = GENERATE(true, false);
  const float height = blocked ? 0.5f : 4.0f;  // behind the point and the spot it blocks nothing
  addQuad(scene, Vec3(-2, height, 2), Vec3(4, 0, 0), Vec3(0, 0, -4),
          add(scene, lambert("lid", Vec3(0))));
  scene.camera.position = Vec3(0, 0.4f, 1);
  for (const PunctualLight& light : {pointAt(Vec3(1, 2, 0), 10), spotBeside(8)}) {
    scene.lights = {light};
    CHECK((irradiance(scene, 4) == 0) == blocked);
  }
  scene.lights = {sun(3)};
  if (blocked) CHECK(irradiance(scene, 4) == 0);
}

TEST_CASE("lights of every kind, triangles that emit and the environment add up") {
  Scene lamps = floorAround();
  addQuad(lamps, Vec3(-0.5f, 1.5f, -0.5f), Vec3(1, 0, 0), Vec3(0, 0, 1),
          add(lamps, lambert("lamp", Vec3(0), Vec3(3))));
  Scene sky = lamps;
  sky.materials.back().emission = Vec3(0);
  Scene punctual = sky;
  sky.environment.color = Vec3(0.7f);
  punctual.lights = {pointAt(Vec3(2, 1, 0), 10), spotBeside(20), sun(2)};
  punctual.lights[1].position = Vec3(0, 1, 0);
  const bool with_lamps = GENERATE(true, false);
  const bool with_sky = GENERATE(true, false);
  Scene all = punctual;
  double expected = irradiance(punctual, 256, 1);
  if (with_lamps) {
    all.materials.back().emission = Vec3(3);
    expected += irradiance(lamps, 256, 1);
  }
  if (with_sky) {
    all.environment = sky.environment;
    expected += irradiance(sky, 256, 1);
  }
  CHECK(irradiance(all, 1024, 1) == Approx(expected).epsilon(0.01));
}

TEST_CASE("ten thousand points light as their sum, whatever their intensities") {
  Scene scene = floorAround();
  double expected = 0;
  for (int i = 0; i < 100; ++i)
    for (int k = 0; k < 100; ++k) {
      const Vec3 place = 0.02f * Vec3(static_cast<float>(i - 50), 50, static_cast<float>(k - 50));
      const float intensity = 0.0001f * static_cast<float>(1 + (i + 7 * k) % 10);
      scene.lights.push_back(pointAt(place, intensity));
      const glm::dvec3 to(place);
      expected += static_cast<double>(intensity) * to.y / std::pow(glm::length(to), 3);
    }
  CHECK(irradiance(scene, 512) == Approx(expected).epsilon(0.005));
}

TEST_CASE("a light's path to a mirror is not looked for, and the mirror shows what it lights") {
  Scene scene = floorAround();
  scene.lights = {pointAt(Vec3(0, 2, 0), 10)};
  Material mirror = lambert("mirror", Vec3(1));
  mirror.metallic = 1;
  mirror.roughness = 0;
  addQuad(scene, Vec3(-2, 0, -2), Vec3(4, 0, 0), Vec3(0, 4, 0), add(scene, mirror));  // faces +z
  scene.camera.position = Vec3(0, 1, 1);
  scene.camera.target = Vec3(0, 0.6f, -2);  // and by the mirror the floor
  const glm::dvec3 seen = meanOf(render(scene, settingsFor(8, 2), 64));
  // From the mirror at z = -2 the ray goes on to the floor at z = 2.5.
  const double z = -2 + 3 * 0.6 / 0.4;
  const double direct = 10 * 2 / std::pow(std::hypot(2.0, z), 3);
  const double image = 10 * 2 / std::pow(std::hypot(2.0, z + 4), 3);  // caustic, not found
  CHECK(seen.g == Approx(kAlbedo / kPi * direct).epsilon(0.01));
  CHECK(seen.g < kAlbedo / kPi * (direct + 0.5 * image));
}
