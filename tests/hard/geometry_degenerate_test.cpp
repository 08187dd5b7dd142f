// Triangles that are none.
#include <catch2/catch.hpp>
#include <limits>

#include "renderer/scene/scene_check.h"
#include "tests/hard/geometry_pictures.h"
#include "tests/hard/geometry_scenes.h"
#include "tests/hard/hard_case.h"

using namespace glimt;
using namespace glimt::test;

namespace {

Image pictureOf(const Scene& scene) {
  return hardPicture(scene, slowDriver() ? 8 : 48, 2, slowDriver() ? 2 : 8);
}

// A point, a line, a corner that comes twice.
void addWithoutArea(Scene& scene) {
  const Vec3 a(-0.5f, 0.25f, 0.75f);
  const Vec3 b(0.5f, 0.5f, 0.5f);
  addTriangle(scene, a, a, a, 0);
  addTriangle(scene, a, 0.5f * a + 0.5f * b, b, 0);
  addTriangle(scene, a, b, b, 0);
  Triangle repeated = scene.triangles.front();
  repeated.positions[2] = repeated.positions[0];
  scene.triangles.push_back(repeated);
}

void addNotFinite(Scene& scene) {
  const float nan = std::numeric_limits<float>::quiet_NaN();
  const float infinity = std::numeric_limits<float>::infinity();
  for (const float bad : {nan, infinity, -infinity})
    for (int axis = 0; axis < 3; ++axis) {
      Vec3 corner(0.5f);
      corner[axis] = bad;
      addTriangle(scene, Vec3(0), corner, Vec3(0, 0.5f, 0), 0);
    }
}

int differentFrom(const Scene& expected, const Scene& scene) {
  return pixelsThatDiffer(pictureOf(scene), pictureOf(expected));
}

}  // namespace

TEST_CASE("what checkScene drops is counted, and the picture is that of the rest") {
  Scene scene = cornellBox();
  addWithoutArea(scene);
  addNotFinite(scene);
  checkScene(scene);
  CHECK(scene.warnings ==
        std::vector<std::string>{"dropped 9 triangles with a vertex that is not a finite number",
                                 "dropped 4 triangles without an area"});
  checkAtMost("geometry", "no area, not finite: dropped", "pixels that differ from without",
              differentFrom(cornellBox(), scene), 0);
}

TEST_CASE("triangles without an area that nobody has dropped are not seen") {
  Scene scene = cornellBox();
  addWithoutArea(scene);
  checkAtMost("geometry", "no area: not dropped", "pixels that differ from without",
              differentFrom(cornellBox(), scene), 0);
}
