// Scenes whose radiance is known without rendering them.
#include <catch2/catch.hpp>

#include <cmath>

#include "tests/image/pictures.h"
#include "tests/image/scenes.h"

using namespace glimt;
using namespace glimt::test;

TEST_CASE("a closed cube that emits 1 and reflects half shows the geometric sum of its bounces") {
  // The last surface samples lights only, which is noisy where they touch: the fewer surfaces are
  // before it, the more of the sum it brings.
  const auto [bounces, samples] =
      GENERATE(table<int, int>({{0, 4096}, {1, 1024}, {4, 128}, {16, 128}}));
  const double expected = furnaceRadiance(0.5, bounces);
  const Image image = render(furnace(0.5f), settingsFor(64, bounces), samples);
  const glm::dvec3 mean = meanOf(image);
  INFO("bounces " << bounces << ", expected " << expected << ", mean " << mean.r);
  for (int channel = 0; channel < 3; ++channel)
    CHECK(mean[channel] == Approx(expected).epsilon(0.002));
  CHECK(darkestBlock(image, 16) > 0.96 * expected);
}

TEST_CASE("a white closed cube loses no light over 64 bounces") {
  const glm::dvec3 mean = meanOf(render(furnace(1), settingsFor(32, 64), 32));
  CHECK(mean.g == Approx(furnaceRadiance(1, 64)).epsilon(0.002));
}

TEST_CASE(
    "a convex body under an even environment has its albedo times the environment's radiance") {
  Scene scene;
  addSphere(scene, 1, 3, add(scene, lambert("body", Vec3(0.9f, 0.5f, 0.1f))));
  scene.environment.color = Vec3(2);
  scene.camera.position = Vec3(0, 0, 3);
  scene.camera.vertical_fov = 20;  // the body fills the picture
  const glm::dvec3 mean = meanOf(render(scene, settingsFor(48, 2), 64));
  CHECK(mean.r == Approx(1.8).epsilon(0.001));
  CHECK(mean.g == Approx(1.0).epsilon(0.001));
  CHECK(mean.b == Approx(0.2).epsilon(0.001));
}

TEST_CASE("an even environment lights a floor alike at every scale") {
  const float scale = GENERATE(1e-4f, 1e-2f, 1.0f, 1e2f, 1e4f, 1e6f);
  Scene scene;
  const std::uint32_t white = add(scene, lambert("white", Vec3(0.8f)));
  addQuad(scene, scale * Vec3(-1, 0, 1), scale * Vec3(2, 0, 0), scale * Vec3(0, 0, -2), white);
  addQuad(scene, scale * Vec3(3, 0, 1), scale * Vec3(0, 1, 0), scale * Vec3(0, 0, -2),
          add(scene, lambert("black", Vec3(0))));
  scene.environment.color = Vec3(1);
  scene.camera.position = scale * Vec3(-0.5f, 1, 0.1f);
  scene.camera.target = scale * Vec3(-0.5f, 0, 0);
  scene.camera.vertical_fov = 20;
  CHECK(meanOf(render(scene, settingsFor(32, 0), 64)).g == Approx(0.8).epsilon(0.02));
}

TEST_CASE("an environment and a shell of the same radiance around everything light a body alike") {
  Scene scene;
  addSphere(scene, 1, 2, add(scene, lambert("body", Vec3(0.7f))));
  addCube(scene, 10, add(scene, lambert("shell", Vec3(0), Vec3(1.5f))));
  scene.environment.color = Vec3(40);  // outside the shell, so never seen
  scene.camera.position = Vec3(0, 0, 3);
  scene.camera.vertical_fov = 20;
  const glm::dvec3 mean = meanOf(render(scene, settingsFor(48, 1), 128));
  CHECK(mean.g == Approx(0.7 * 1.5).epsilon(0.003));
}

// Irradiance at a point from a square of half width a, parallel and at height h above it:
// 4 * radiance * view factor of a quarter, as tabulated by Howell, configuration C-2 (one corner
// over the point).
double squareIrradiance(double a, double h, double radiance) {
  const double x = a / h;
  const double s = std::sqrt(1 + x * x);
  return 4 * radiance * (x / s) * std::atan(x / s);
}

TEST_CASE("a floor under a square light has the irradiance of the closed form") {
  const bool two_sided = GENERATE(false, true);
  Scene scene;
  Material light = lambert("light", Vec3(0), Vec3(10));
  light.double_sided = two_sided;
  addQuad(scene, Vec3(-5, 0, 5), Vec3(10, 0, 0), Vec3(0, 0, -10),
          add(scene, lambert("floor", Vec3(0.6f))));
  addQuad(scene, Vec3(-0.5f, 1, -0.5f), Vec3(1, 0, 0), Vec3(0, 0, 1), add(scene, light));
  scene.camera.position = Vec3(3, 1, 0);
  scene.camera.target = Vec3(0, 0, 0);
  scene.camera.vertical_fov = 0.5f;  // the spot under the light's centre
  const glm::dvec3 mean = meanOf(render(scene, settingsFor(16, 0), 512));
  const double pi = std::acos(-1.0);
  CHECK(mean.r == Approx(0.6 / pi * squareIrradiance(0.5, 1, 10)).epsilon(0.003));
}

TEST_CASE("a one-sided light is black and dark from behind") {
  Scene scene;
  Material light = lambert("light", Vec3(0), Vec3(10));
  light.double_sided = false;
  addQuad(scene, Vec3(-2, 0, -2), Vec3(4, 0, 0), Vec3(0, 4, 0), add(scene, light));  // faces +z
  addQuad(scene, Vec3(-2, 0, -5), Vec3(4, 0, 0), Vec3(0, 4, 0),
          add(scene, lambert("wall", Vec3(1))));
  scene.camera.position = Vec3(0, 2, -3.5f);
  scene.camera.target = Vec3(0, 2, 0);
  SECTION("looking at the light's back") {}
  SECTION("looking at the wall behind it") {
    scene.camera.target = Vec3(0, 2, -5);
  }
  CHECK(meanOf(render(scene, settingsFor(16, 3), 16)) == glm::dvec3(0));
}

TEST_CASE("smooth normals change the shading and not the light that a closed furnace holds") {
  Scene scene = furnace(0.5f);
  for (Triangle& triangle : scene.triangles) {
    for (std::size_t corner = 0; corner < 3; ++corner) {
      triangle.normals[corner] = static_cast<std::uint32_t>(scene.normals.size());
      scene.normals.push_back(-glm::normalize(scene.positions[triangle.positions[corner]]));
    }
  }
  // A direction that the bent normal allows but the wall does not is lost, so some light is.
  const double mean = meanOf(render(scene, settingsFor(32, 0), 64)).g;
  CHECK(mean < furnaceRadiance(0.5, 0));
  CHECK(mean > 0.85 * furnaceRadiance(0.5, 0));
}
