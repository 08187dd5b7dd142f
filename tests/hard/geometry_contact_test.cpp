// Surfaces that lie on each other.
#include <catch2/catch.hpp>

#include "tests/hard/geometry_pictures.h"
#include "tests/hard/geometry_scenes.h"
#include "tests/hard/hard_case.h"
#include "tests/image/scenes.h"

using namespace glimt;
using namespace glimt::test;

namespace {

int size() {
  return slowDriver() ? 8 : 64;
}

Image insideOf(const Scene& scene) {
  return hardPicture(shiningOutside(scene), size(), 7, slowDriver() ? 4 : 32);
}

Scene withMaterial() {
  Scene scene;
  add(scene, lambert("wall", Vec3(1)));
  return scene;
}

}  // namespace

TEST_CASE("walls that are there twice give the picture of walls that are there once") {
  const Scene once = cornellBox();
  Scene twice = once;
  for (const Triangle& triangle : once.triangles)
    if (once.materials[triangle.material].emission == Vec3(0)) twice.triangles.push_back(triangle);
  const int samples = slowDriver() ? 2 : 32;
  const Image expected = hardPicture(once, size(), 4, samples);
  // The paths are the same, but for those that a different tree sends another way at an edge.
  checkAtMost("geometry", "every wall twice", "mean difference from once, relative",
              meanDifference(hardPicture(twice, size(), 4, samples), expected), 0.002);
}

TEST_CASE("no ray leaves two boxes that share a face") {
  Scene scene = withMaterial();
  addBlock(scene, Vec3(-1, -1, -1), Vec3(0, 1, 1), 0);
  addBlock(scene, Vec3(0, -1, -1), Vec3(1, 1, 1), 0);
  scene.camera.position = Vec3(-0.7f, 0.2f, 0.6f);
  scene.camera.target = Vec3(0, -0.3f, 0);
  checkAtMost("geometry", "two boxes that share a face", "pixels with light of outside",
              pixelsOtherThan(insideOf(scene), Vec3(0)), 0);
}

TEST_CASE("no ray leaves a room with a box that rests on its floor") {
  Scene scene = withMaterial();
  addBlock(scene, Vec3(-1), Vec3(1), 0);
  addBlock(scene, Vec3(-0.3f, -1, -0.3f), Vec3(0.4f, 0, 0.2f), 0);
  scene.camera.position = Vec3(0.3f, 0.2f, 0.7f);
  scene.camera.target = Vec3(0, -0.8f, 0);
  checkAtMost("geometry", "room with a box on its floor", "pixels with light of outside",
              pixelsOtherThan(insideOf(scene), Vec3(0)), 0);
}

// The hit record moves a point on the floor by up to a cell of 2^-16 of the floor, that is by 60
// micrometres here, which may be to the other side of the box's wall.
TEST_CASE("next to no light gets under a box that rests on a floor") {
  const bool with_bottom = GENERATE(true, false);
  Scene scene = withMaterial();
  addQuad(scene, Vec3(-2, 0, 2), Vec3(4, 0, 0), Vec3(0, 0, -4), 0);
  addBlock(scene, Vec3(-0.3f, 0, -0.3f), Vec3(0.4f, 0.6f, 0.2f), 0);
  if (!with_bottom)
    std::erase_if(scene.triangles, [&](const Triangle& triangle) {
      const auto [a, b, c] = triangle.positions;
      return a >= 6 && scene.positions[a].y == 0 && scene.positions[b].y == 0 &&
             scene.positions[c].y == 0;
    });
  scene.camera.position = Vec3(0.3f, 0.3f, 0.1f);
  scene.camera.target = Vec3(0, 0, 0);
  scene.camera.vertical_fov = 80;
  checkAtMost(
      "geometry",
      with_bottom ? "box on a floor, from inside" : "box without a bottom on a floor, from inside",
      "mean, part of the light outside", brightnessOf(insideOf(scene)), 0.001);
}
