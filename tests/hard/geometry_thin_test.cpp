// Triangles that are far longer than wide, and as many of them at one point as there can be.
#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>

#include "tests/hard/geometry_pictures.h"
#include "tests/hard/geometry_scenes.h"
#include "tests/hard/hard_case.h"
#include "tests/image/scenes.h"

using namespace glimt;
using namespace glimt::test;

namespace {

constexpr float kLength = 100;

// A tunnel of 100 m by 10 cm by 10 cm, its long walls cut along it into so many strips each. A
// light fills its near end, behind the camera.
Scene tunnel(int strips) {
  Scene scene;
  const std::uint32_t wall = add(scene, lambert("wall", Vec3(0.7f)));
  const std::uint32_t light = add(scene, lambert("light", Vec3(0), Vec3(1)));
  const Vec3 along(0, 0, -kLength);
  const Vec3 x(0.1f, 0, 0);
  const Vec3 y(0, 0.1f, 0);
  const Vec3 corner(-0.05f, -0.05f, 0);
  addStrips(scene, corner, along, x, strips, wall);
  addStrips(scene, corner + y, along, x, strips, wall);
  addStrips(scene, corner, along, y, strips, wall);
  addStrips(scene, corner + x, along, y, strips, wall);
  addQuad(scene, corner, x, y, light);
  addQuad(scene, corner + along, x, y, wall);
  scene.camera.position = Vec3(0.01f, 0.02f, -0.05f);
  scene.camera.target = Vec3(0.02f, -0.01f, -1);
  scene.camera.vertical_fov = 80;
  return scene;
}

// A white wall of 2 m under an even sky, of which a band in the middle is cut into strips of two
// micrometres.
Scene wallWithStrips(int strips) {
  Scene scene;
  const std::uint32_t wall = add(scene, lambert("wall", Vec3(0.8f)));
  const float band = 1e-4f;
  addQuad(scene, Vec3(-1, -1, 0), Vec3(2, 0, 0), Vec3(0, 1 - band, 0), wall);
  addStrips(scene, Vec3(-1, -band, 0), Vec3(2, 0, 0), Vec3(0, 2 * band, 0), strips, wall);
  addQuad(scene, Vec3(-1, band, 0), Vec3(2, 0, 0), Vec3(0, 1 - band, 0), wall);
  scene.environment.color = Vec3(1);
  scene.camera.position = Vec3(0.3f, 0, 1);
  scene.camera.target = Vec3(0.3f, 0, 0);
  scene.camera.vertical_fov = 0.01f;  // sees 87 of the strips
  return scene;
}

// Black triangles of a disk of radius one around the origin, facing along z, before an even sky.
Scene fan(int triangles) {
  Scene scene;
  const std::uint32_t black = add(scene, lambert("black", Vec3(0)));
  const auto rim = [&](int i) {
    const double angle = 2 * std::numbers::pi * (i % triangles) / triangles;
    return Vec3(std::cos(angle), std::sin(angle), 0);
  };
  for (int i = 0; i < triangles; ++i) addTriangle(scene, Vec3(0), rim(i), rim(i + 1), black);
  scene.environment.color = Vec3(1);
  return scene;
}

// Rays to the middle meet the boxes of all triangles, so few of them are sent.
int litPixels(const Scene& scene) {
  const int size = slowDriver() ? 6 : 32;
  return pixelsOtherThan(hardPicture(scene, size, 0, slowDriver() ? 1 : 4), Vec3(0));
}

}  // namespace

TEST_CASE("no ray leaves a closed tunnel of slivers") {
  const int strips = slowDriver() ? 100 : 1000;
  Scene scene = shiningOutside(tunnel(strips));
  const int size = slowDriver() ? 8 : 48;
  const Image image = hardPicture(scene, size, 7, slowDriver() ? 2 : 16);
  checkAtMost("geometry", "tunnel of slivers, 1:1,000,000", "pixels with light of outside",
              pixelsOtherThan(image, Vec3(0)), 0);
}

TEST_CASE("a tunnel of slivers looks like one of long quads") {
  const int size = slowDriver() ? 8 : 48;
  const int samples = slowDriver() ? 8 : 64;
  const Image expected = hardPicture(tunnel(1), size, 4, samples);
  const Image image = hardPicture(tunnel(slowDriver() ? 100 : 1000), size, 4, samples);
  checkAtMost("geometry", "tunnel of slivers, 1:1,000,000", "mean difference from quads, relative",
              meanDifference(image, expected), slowDriver() ? 0.1 : 0.005);
}

TEST_CASE("a wall of slivers under an even sky is as bright as its albedo") {
  const int size = slowDriver() ? 8 : 64;
  for (const int strips : {1, 100}) {
    const Image image = hardPicture(wallWithStrips(strips), size, 2, slowDriver() ? 4 : 32);
    checkAtMost("geometry",
                strips == 1 ? "wall with a band of 1:10,000" : "wall of slivers, 1:1,000,000",
                "mean difference from its albedo, relative",
                std::abs(brightnessOf(image) / 0.8 - 1), 0.001);
  }
}

TEST_CASE("nothing is seen through a fan of ten thousand triangles") {
  Scene scene = fan(10000);
  scene.camera.position = Vec3(0, 0, 2);
  scene.camera.vertical_fov = 35;
  checkAtMost("geometry", "fan of 10,000, face-on", "pixels seen through it", litPixels(scene), 0);
  scene.camera.vertical_fov = 0.01f;
  checkAtMost("geometry", "fan of 10,000, its middle", "pixels seen through it", litPixels(scene),
              0);
  // A thousandth of a radian above its plane, where the disk fills the picture's height.
  scene.camera.position = Vec3(0, -3, 0.003f);
  scene.camera.up = Vec3(0, 0, 1);
  scene.camera.vertical_fov = 0.02f;
  checkAtMost("geometry", "fan of 10,000, near edge-on", "pixels seen through it", litPixels(scene),
              0);
}

TEST_CASE("a fan that is seen from its own plane hides at most a line") {
  Scene scene = fan(10000);
  scene.camera.position = Vec3(0, -3, 0);
  scene.camera.up = Vec3(0, 0, 1);
  const int size = slowDriver() ? 32 : 128;
  const Image image = hardPicture(scene, size, 0, 4);
  checkAtMost("geometry", "fan of 10,000, edge-on", "pixels that it darkens",
              pixelsOtherThan(image, Vec3(1)), 2 * size);
}
