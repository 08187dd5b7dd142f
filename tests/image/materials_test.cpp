// Bodies of every lobe under an even environment, through the shaders as a scene composes them. A
// white body that keeps all light is as bright as the environment. Each effect is also compiled
// alone here.
#include <catch2/catch.hpp>

#include "tests/image/pictures.h"
#include "tests/image/scenes.h"

using namespace glimt;
using namespace glimt::test;

namespace {

// Seen from so near that it fills the picture.
double radianceOf(const Material& material, int bounces, int samples) {
  Scene scene;
  addSphere(scene, 1, 3, add(scene, material));
  scene.environment.color = Vec3(1);
  scene.camera.position = Vec3(0, 0, 3);
  scene.camera.vertical_fov = 20;
  return meanOf(render(scene, settingsFor(32, bounces), samples)).g;
}

Material white() {
  return lambert("white", Vec3(1));
}

}  // namespace

TEST_CASE("a white body under a clear coat or fibres is as bright as the environment") {
  Material m = white();
  SECTION("a smooth coat") {
    m.clearcoat = 1;
  }
  SECTION("a rough coat") {
    m.clearcoat = 0.5f;
    m.clearcoat_roughness = 0.4f;
  }
  SECTION("fibres") {
    m.sheen_color = Vec3(1);
    m.sheen_roughness = 0.3f;
  }
  SECTION("both, over gloss") {
    m.sheen_color = Vec3(0.5f);
    m.clearcoat = 1;
    m.specular = 1;
    m.roughness = 0.3f;
  }
  SECTION("a mirror alone") {
    m.metallic = 1;
    m.roughness = 0;
  }
  CHECK(radianceOf(m, 2, 128) == Approx(1).epsilon(0.01));
}

TEST_CASE("a body of white glass, or of thin walls, is as bright as the environment") {
  Material m = white();
  m.transmission = 1;
  m.specular = 1;
  m.thin_walled = GENERATE(false, true);
  m.roughness = GENERATE(0.0f, 0.3f, 1.0f);
  INFO("thin " << m.thin_walled << ", roughness " << m.roughness);
  CHECK(radianceOf(m, 32, 32) == Approx(1).epsilon(0.02));
}

TEST_CASE("a slab that bends nothing leaves the share of light that its thickness says") {
  Scene scene;
  Material m = white();
  m.transmission = 1;
  m.specular = 1;
  m.roughness = 0;
  m.ior = 1;
  m.attenuation_color = Vec3(0.5f, 1, 0.25f);
  m.attenuation_distance = 0.5f;
  addCube(scene, 0.5f, add(scene, m));
  scene.environment.color = Vec3(1);
  scene.camera.vertical_fov = 1;
  const auto mean = [&](const Vec3& from) {
    scene.camera.position = from;
    scene.camera.target = from - Vec3(0, 0, 1);
    return meanOf(render(scene, settingsFor(16, 4), 16));
  };
  const glm::dvec3 through = mean(Vec3(0, 0, 3));
  CHECK(through.r == Approx(0.25).epsilon(0.01));
  CHECK(through.g == Approx(1).epsilon(0.01));
  CHECK(through.b == Approx(0.0625).epsilon(0.01));
  // The camera is inside: the ray to the back counts from there.
  CHECK(mean(Vec3(0)).r == Approx(0.5).epsilon(0.01));
}
