// No ray leaves a closed mesh. Outside everything shines, inside nothing does: what the picture of
// a camera inside holds has come through the walls.
#include <catch2/catch.hpp>

#include "tests/hard/hard_case.h"
#include "tests/image/pictures.h"
#include "tests/image/scenes.h"

using namespace glimt;
using namespace glimt::test;

namespace {

constexpr int kBounces = 7;  // so that a sample of a pixel is 8 rays and as many shadow rays

// White, so that no path ends but by leaving.
Scene shiningOutside(Scene scene) {
  scene.environment.color = Vec3(1);
  for (Material& material : scene.materials) material = lambert("wall", Vec3(1));
  return scene;
}

Scene box() {
  Scene scene;
  addCube(scene, 1, add(scene, lambert("wall", Vec3(1))), true);
  scene.camera.position = Vec3(0.3f, 0.2f, 0.7f);
  return shiningOutside(scene);
}

Scene sphere() {
  Scene scene;
  addSphere(scene, 1, 4, add(scene, lambert("wall", Vec3(1))));
  scene.camera.position = Vec3(0.3f, 0.2f, 0.7f);
  return shiningOutside(scene);
}

// Pixels that have seen any light of outside.
double lit(const Scene& scene, int size, int samples) {
  ContextHandle context = hardContext();
  Renderer renderer(context, scene, settingsFor(size, kBounces));
  while (renderer.samples() < samples) renderer.renderSample();
  CHECK(renderer.nonfinitePixels() == 0);
  double count = 0;
  for (const Vec3& pixel : renderer.radiance().pixels) count += pixel.x + pixel.y + pixel.z > 0;
  return count;
}

}  // namespace

TEST_CASE("no ray leaves a closed box or a closed sphere of 2,048 triangles") {
  const int size = slowDriver() ? 16 : 64;
  const int samples = slowDriver() ? 4 : 32;
  const std::string what = "pixels with light of outside";
  checkAtMost("leakage", "box", what, lit(box(), size, samples), 0);
  checkAtMost("leakage", "sphere", what, lit(sphere(), size, samples), 0);
}

TEST_CASE("a box with a hole is found out") {
  Scene open = box();
  open.triangles.pop_back();
  CHECK(lit(open, 16, 4) > 0);
}
