// No ray leaves a closed mesh. Outside everything shines, inside nothing does: what the picture of
// a camera inside holds has come through the walls.
#include <catch2/catch.hpp>
#include <cstdlib>
#include <iostream>

#include "renderer/bench/knot.h"
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

// The tube of 70,000 triangles, or of 2,100 on slow drivers, along its middle.
Scene knot() {
  Scene scene;
  add(scene, lambert("wall", Vec3(1)));
  addKnot(scene, slowDriver() ? KnotSize{70, 15} : KnotSize{648, 54});
  scene.camera.position = Vec3(3, 0, 0);
  scene.camera.target = Vec3(3, 0.6f, 0.3f);
  scene.camera.vertical_fov = 80;
  return shiningOutside(scene);
}

// Two walls that meet at 10 degrees, a third one across, and two ends; 256 m from the origin, where
// rays leave a wall from 0.2 mm above it.
Scene wedge() {
  Scene scene;
  const std::uint32_t wall = add(scene, lambert("wall", Vec3(1)));
  const float rise = 2 * std::tan(glm::radians(5.0f));
  const float far = 256;
  const Vec3 edge(far, 0, -1);
  const Vec3 top(far + 2, rise, -1);
  const Vec3 bottom(far + 2, -rise, -1);
  const Vec3 along(0, 0, 2);
  addQuad(scene, edge, top - edge, along, wall);
  addQuad(scene, edge, along, bottom - edge, wall);
  addQuad(scene, bottom, along, top - bottom, wall);
  addTriangle(scene, edge, bottom, top, wall);
  addTriangle(scene, edge + along, top + along, bottom + along, wall);
  scene.camera.position = Vec3(far + 1.9f, 0.01f, 0.02f);
  scene.camera.target = edge + along * 0.5f;
  scene.camera.vertical_fov = 60;
  return shiningOutside(scene);
}

int litPixels(Renderer& renderer) {
  CHECK(renderer.nonfinitePixels() == 0);
  int count = 0;
  for (const Vec3& pixel : renderer.radiance().pixels) count += pixel.x + pixel.y + pixel.z > 0;
  return count;
}

// Pixels that have seen any light of outside.
int lit(const Scene& scene, int size, int samples) {
  ContextHandle context = hardContext();
  Renderer renderer(context, scene, settingsFor(size, kBounces));
  while (renderer.samples() < samples) renderer.renderSample();
  return litPixels(renderer);
}

// How many rays the long test sends at least, into each mesh. A billion is a night's work.
double longTestRays() {
  const char* rays = std::getenv("GLIMT_HARD_RAYS");
  return rays ? std::atof(rays) : 1e8;
}

void sendManyRays(const std::string& name, const Scene& scene) {
  ContextHandle context = hardContext();
  Renderer renderer(context, scene, settingsFor(512, kBounces));
  renderer.renderSample();
  const RenderStatistics sample = renderer.statistics();
  const double rays = sample.camera_rays + sample.bounce_rays + sample.shadow_rays;
  while (rays * renderer.samples() < longTestRays()) renderer.renderSample();
  std::cout << name << ": " << rays * renderer.samples() << " rays\n";
  checkAtMost("leakage", name + ", 1e8 rays", "pixels with light of outside", litPixels(renderer),
              0);
}

}  // namespace

TEST_CASE("no ray leaves a closed box, sphere of 2,048, knot of 70,000 triangles or wedge") {
  const int size = slowDriver() ? 16 : 64;
  const int samples = slowDriver() ? 4 : 32;
  const std::string what = "pixels with light of outside";
  checkAtMost("leakage", "box", what, lit(box(), size, samples), 0);
  checkAtMost("leakage", "sphere", what, lit(sphere(), size, samples), 0);
  checkAtMost("leakage", "knot", what, lit(knot(), size, samples), 0);
  checkAtMost("leakage", "wedge of 10 degrees", what, lit(wedge(), size, samples), 0);
}

TEST_CASE("a box with a hole is found out") {
  Scene open = box();
  open.triangles.pop_back();
  CHECK(lit(open, 16, 4) > 0);
}

// Takes minutes on llvmpipe, and a day on the interpreters.
TEST_CASE("none of 1e8 rays leaves a closed box, sphere, knot or wedge", "[long]") {
  if (slowDriver()) return;
  sendManyRays("box", box());
  sendManyRays("sphere", sphere());
  sendManyRays("knot", knot());
  sendManyRays("wedge of 10 degrees", wedge());
}
