// A picture does not depend on the unit of length, nor on where the scene is.
#include <fmt/format.h>

#include <catch2/catch.hpp>
#include <cmath>

#include "renderer/scene/load_scene.h"
#include "tests/hard/geometry_pictures.h"
#include "tests/hard/geometry_scenes.h"
#include "tests/hard/hard_case.h"
#include "tests/image/pictures.h"
#include "tests/unit/temporary_folder.h"

using namespace glimt;
using namespace glimt::test;

namespace {

int size() {
  return slowDriver() ? 16 : 64;
}

int samples() {
  return slowDriver() ? 2 : 16;
}

Image pictureOf(const Scene& scene) {
  return hardPicture(scene, size(), 4, samples());
}

// The same random numbers give the same paths, but for those that an edge sends another way. Few
// do: an edge is uncertain by 1e-7 of the scene, and a pixel is 1e-2 of it. One path that meets the
// light where it did not moves the mean of about 0.5 by 17 / 65,536, or by 17 / 512 on slow
// drivers.
double meanBound() {
  return slowDriver() ? 0.07 : 0.002;
}

// And that of a block of 8 x 8 pixels by 17 / 1024, or by 17 / 128.
double blockBound() {
  return slowDriver() ? 0.3 : 0.05;
}

void compare(const std::string& name, const Image& image, const Image& expected) {
  checkAtMost("geometry", name, "mean difference, relative", meanDifference(image, expected),
              meanBound());
  checkAtMost("geometry", name, "worst block of 8 x 8, part of the mean",
              worstBlockDifference(image, expected, 8), blockBound());
}

std::string objOf(const Scene& scene, const glm::dvec3& offset) {
  std::string text = "mtllib box.mtl\n";
  for (const Vec3& position : scene.positions) {
    const glm::dvec3 p = offset + glm::dvec3(position);
    text += fmt::format("v {:.17g} {:.17g} {:.17g}\n", p.x, p.y, p.z);
  }
  for (const Triangle& triangle : scene.triangles)
    text += fmt::format("usemtl {}\nf {} {} {}\n", scene.materials[triangle.material].name,
                        triangle.positions[0] + 1, triangle.positions[1] + 1,
                        triangle.positions[2] + 1);
  return text;
}

std::string mtlOf(const Scene& scene) {
  std::string text;
  for (const Material& m : scene.materials)
    text += fmt::format("newmtl {}\nKd {} {} {}\nKe {} {} {}\n", m.name, m.base_color.r,
                        m.base_color.g, m.base_color.b, m.emission.r, m.emission.g, m.emission.b);
  return text;
}

// The scene as files would have it that far from their origin, read back.
Scene loadedAt(const Scene& scene, const glm::dvec3& offset) {
  const TemporaryFolder folder;
  folder.write("box.mtl", mtlOf(scene));
  folder.write("box.obj", objOf(scene, offset));
  const glm::dvec3 eye = offset + glm::dvec3(scene.camera.position);
  const glm::dvec3 target = offset + glm::dvec3(scene.camera.target);
  return loadScene(folder.write(
      "box.scene.json", fmt::format(R"({{"model": "box.obj", "environment": {{"color": [0, 0, 0]}},
      "camera": {{"position": [{:.17g}, {:.17g}, {:.17g}], "target": [{:.17g}, {:.17g}, {:.17g}]}},
      "materials": {{"light": {{"double_sided": false}}}}}})",
                                    eye.x, eye.y, eye.z, target.x, target.y, target.z)));
}

}  // namespace

TEST_CASE("a scene in another unit of length gives the same picture") {
  const Scene scene = cornellBox();
  const Image expected = pictureOf(scene);
  for (const float scale : {1e-4f, 1e-2f, 1e2f, 1e4f})
    compare(fmt::format("box, {:g} times as large", scale),
            pictureOf(transformed(scene, scale, Vec3(0))), expected);
}

TEST_CASE("a scene scaled by a power of two gives the same picture, bit for bit") {
  const Scene scene = cornellBox();
  const Image expected = pictureOf(scene);
  for (const int exponent : {-14, 14}) {
    const Image image = pictureOf(transformed(scene, std::ldexp(1.0f, exponent), Vec3(0)));
    checkAtMost("geometry", fmt::format("box, 2^{} times as large", exponent),
                "pixels that differ in any bit", pixelsThatDiffer(image, expected), 0);
  }
}

TEST_CASE("a scene file far from its origin gives the same picture") {
  const Scene scene = cornellBox();
  const Image expected = pictureOf(scene);
  for (const double sizes : {1e3, 1e6}) {
    const Scene far = loadedAt(scene, 2 * sizes * glm::dvec3(1, -0.7, 0.3));
    compare(fmt::format("box read from {:g} times its size away", sizes), pictureOf(far), expected);
  }
}

// In floats: vertices are rounded to 1e-4 of the box's size, and rays that leave a surface start
// 1e-3 of it away, which blurs the shadows' edges by as much.
TEST_CASE("a scene that is far from the origin in floats gives about the same picture") {
  const Scene scene = cornellBox();
  const Image expected = pictureOf(scene);
  const Image image = pictureOf(transformed(scene, 1, 2e3f * Vec3(1, -0.7f, 0.3f)));
  checkAtMost("geometry", "box 1000 times its size away, in floats", "mean difference, relative",
              meanDifference(image, expected), slowDriver() ? 0.07 : 0.01);
}
