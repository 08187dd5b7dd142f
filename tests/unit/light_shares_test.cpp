#include "renderer/passes/light_shares.h"

#include <catch2/catch.hpp>

#include "renderer/scene/scene.h"

using namespace glimt;

namespace {

// A floor of 100 square metres, and above it a lamp of one.
Scene floorAndLamp(float radiance) {
  Scene scene;
  scene.positions = {Vec3(0),       Vec3(20, 0, 0), Vec3(0, 0, 10),
                     Vec3(0, 3, 0), Vec3(2, 3, 0),  Vec3(0, 3, 1)};
  scene.materials.resize(2);
  scene.materials[1].emission = Vec3(radiance);
  scene.materials[1].double_sided = false;
  scene.triangles.resize(2);
  scene.triangles[0].positions = {0, 1, 2};
  scene.triangles[1].positions = {3, 4, 5};
  scene.triangles[1].material = 1;
  return scene;
}

LightShares bothSharesOf(const Scene& scene) {
  return lightShares(scene, buildLightTable(scene));
}

Vec3 sharesOf(const Scene& scene) {
  return bothSharesOf(scene).usual;
}

}  // namespace

TEST_CASE("what is not there gets no light samples") {
  Scene scene = floorAndLamp(0);
  CHECK(sharesOf(scene) == Vec3(0));
  scene.environment.color = Vec3(1);
  CHECK(sharesOf(scene) == Vec3(1, 0, 0));
  scene.environment.color = Vec3(0);
  scene.lights.emplace_back();
  CHECK(sharesOf(scene) == Vec3(0, 0, 1));
  scene.lights.clear();
  scene.materials[1].emission = Vec3(5);
  CHECK(sharesOf(scene) == Vec3(0, 1, 0));
}

TEST_CASE("an even environment's share grows with its light beside that of the lamps") {
  Scene scene = floorAndLamp(100);
  float before = 0;
  for (const float radiance : {0.1f, 1.0f, 8.0f, 100.0f}) {
    scene.environment.color = Vec3(radiance);
    const Vec3 shares = sharesOf(scene);
    CHECK(shares.x + shares.y + shares.z == Approx(1));
    CHECK(shares.x >= before);
    before = shares.x;
    if (radiance < 2) CHECK(shares.x == Approx(1.0 / 16));
  }
  CHECK(before == Approx(0.5));
}

TEST_CASE("where no ray finds the environment by chance it gets a quarter at least") {
  Scene scene = floorAndLamp(100);
  scene.environment.color = Vec3(0.1f);
  CHECK(bothSharesOf(scene).alone.x == Approx(0.25));
  scene.environment.color = Vec3(1);
  const LightShares shares = bothSharesOf(scene);
  CHECK(shares.alone.x > 0.25f);
  CHECK(shares.alone.x < 0.75f);
  CHECK(shares.alone.x + shares.alone.y + shares.alone.z == Approx(1));
}

TEST_CASE("a picture of the sky and what is nearby get half of the light samples each") {
  Scene scene = floorAndLamp(100);
  scene.environment.color = Vec3(1);
  scene.environment.image = {2, 1, {Vec3(1), Vec3(1e6f)}};
  CHECK(sharesOf(scene) == Vec3(0.5f, 0.5f, 0));
}

TEST_CASE("lights of a scene without surfaces have shares all the same") {
  Scene scene;
  scene.environment.color = Vec3(1);
  scene.lights.emplace_back();
  const Vec3 shares = sharesOf(scene);
  CHECK(shares.x + shares.z == Approx(1));
  CHECK(shares.x > 0);
}

TEST_CASE("neither lamps nor lights without triangles get less than a quarter of the rest") {
  Scene scene = floorAndLamp(1e-6f);
  scene.lights.emplace_back();
  CHECK(sharesOf(scene).y == Approx(0.25));
  scene.materials[1].emission = Vec3(1e6f);
  CHECK(sharesOf(scene).z == Approx(0.25));
}
