// Shading normals that do not fit the geometry: they may change the shading, and nothing else.
#include <fmt/format.h>

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <vector>

#include "renderer/scene/scene_check.h"
#include "tests/hard/bsdfs.h"
#include "tests/hard/hard_case.h"
#include "tests/hard/hard_picture.h"
#include "tests/image/pictures.h"

using namespace glimt;
using namespace glimt::test;

namespace {

Vec3 geometricNormal(const Scene& scene, const Triangle& triangle) {
  const Vec3& a = scene.positions[triangle.positions[0]];
  return glm::normalize(glm::cross(scene.positions[triangle.positions[1]] - a,
                                   scene.positions[triangle.positions[2]] - a));
}

// Normals of every corner, as `normalAt` makes them of the triangle's and the corner's number.
template <class NormalAt>
void giveNormals(Scene& scene, const NormalAt& normalAt) {
  int corner = 0;
  for (Triangle& triangle : scene.triangles)
    for (std::uint32_t& index : triangle.normals) {
      index = static_cast<std::uint32_t>(scene.normals.size());
      scene.normals.push_back(normalAt(geometricNormal(scene, triangle), corner++));
    }
}

// Away from the geometric normal by that angle, at each corner in another direction.
void tiltNormals(Scene& scene, double degrees) {
  const double angle = degrees * std::acos(-1.0) / 180;
  giveNormals(scene, [angle](const glm::dvec3& normal, int corner) {
    const double turn = 2.4 * corner;  // the golden angle: no two alike
    const glm::dvec3 axis(std::cos(turn), std::sin(turn), std::cos(2 * turn));
    const glm::dvec3 side = glm::normalize(axis - glm::dot(axis, normal) * normal);
    return Vec3(std::cos(angle) * normal + std::sin(angle) * side);
  });
}

// A ball and a lamp over a floor, seen from the side that the sky lights.
Scene ball(const Material& surface) {
  Scene scene;
  const std::uint32_t material = add(scene, surface);
  addSphere(scene, 1, 2, material);
  addQuad(scene, Vec3(-3, -1, 3), Vec3(6, 0, 0), Vec3(0, 0, -6), material);
  addQuad(scene, Vec3(-1, 3, -1), Vec3(2, 0, 0), Vec3(0, 0, 2),
          add(scene, lambert("lamp", Vec3(0), Vec3(4))));
  scene.environment.color = Vec3(0.5f);
  scene.camera.position = Vec3(2, 1.5f, 4);
  return scene;
}

// Of a closed ball that emits, of what there is with normals that fit.
double energyInside(const Material& white, double degrees, int bounces) {
  Scene scene;
  addSphere(scene, 1, 2, add(scene, white));
  scene.camera = furnace(0).camera;
  scene.camera.position *= 0.5f;
  tiltNormals(scene, degrees);
  // The weights of rough metal's paths multiply: of a quarter of these samples the mean would
  // deviate by as much as is lost.
  const bool noisy = white.metallic == 1 && white.roughness > 0.5f;
  const int size = slowDriver() && !noisy ? 16 : 24;
  return meanRadiance(hardPicture(scene, settingsFor(size, bounces), noisy ? 256 : 32)) /
         furnaceRadiance(1, bounces);
}

// Of a ball that fills the picture, under an even sky of 1.
double brightnessOutside(const Material& white, double degrees) {
  Scene scene;
  addSphere(scene, 1, 3, add(scene, white));
  tiltNormals(scene, degrees);
  scene.environment.color = Vec3(1);
  scene.camera.position = Vec3(0, 0, 3);
  scene.camera.vertical_fov = 20;
  const int size = slowDriver() ? 16 : 32;
  return meanRadiance(hardPicture(scene, settingsFor(size, 4), 32));
}

void flipWinding(Scene& scene) {
  for (Triangle& triangle : scene.triangles) {
    std::swap(triangle.positions[1], triangle.positions[2]);
    std::swap(triangle.normals[1], triangle.normals[2]);
  }
}

Image pictureOf(const Scene& scene) {
  return hardPicture(scene, settingsFor(slowDriver() ? 24 : 64, 2), 48);
}

// The largest difference of two blocks of 8 x 8 pixels, relative to the mean of the picture.
double blockDifference(const Image& a, const Image& b) {
  double largest = 0;
  for (int top = 0; top + 8 <= a.height; top += 8)
    for (int left = 0; left + 8 <= a.width; left += 8) {
      double sum = 0;
      for (int i = 0; i < 64; ++i) {
        const int at = (top + i / 8) * a.width + left + i % 8;
        sum += a.pixels[static_cast<std::size_t>(at)].g - b.pixels[static_cast<std::size_t>(at)].g;
      }
      largest = std::max(largest, std::abs(sum) / 64);
    }
  return largest / meanRadiance(a);
}

}  // namespace

TEST_CASE("a furnace with tilted normals is finite and gains no energy") {
  const auto check = [](const char* name, const Material& white, int bounces,
                        const std::vector<double>& tilts) {
    double most = 0;
    for (const double degrees : tilts) most = std::max(most, energyInside(white, degrees, bounces));
    checkAtMost("shading",
                fmt::format("normals tilted by {:g} to {:g} degrees, {}", tilts.front(),
                            tilts.back(), name),
                "energy in a closed furnace, of what there is", most, 1.005);
  };
  for (const Bsdf& bsdf : kBsdfs)
    check(bsdf.name, bsdf.material(1, 1), 8, {0, 30, 60, 85, 89.99, 90, 91, 120, 180});
  // Where nothing gets lost, the noise of gloss would show; see lossless_test.cpp.
  for (const LosslessBsdf& bsdf : kReflectors)
    check(bsdf.name, bsdf.material(1), 2, {60, 85, 89.99, 91, 120});
}

TEST_CASE("a ball with tilted normals reflects no more than an even sky brings") {
  const auto check = [](const char* name, const Material& white) {
    double most = 0;
    for (const double degrees : {0.0, 60.0, 89.99, 91.0, 120.0, 180.0})
      most = std::max(most, brightnessOutside(white, degrees));
    checkAtMost("shading", fmt::format("normals tilted on a ball, {}", name),
                "radiance under an even sky of 1", most, 1.005);
  };
  for (const Bsdf& bsdf : kBsdfs) check(bsdf.name, bsdf.material(1, 0));
  for (const LosslessBsdf& bsdf : kReflectors) check(bsdf.name, bsdf.material(0));
}

TEST_CASE("zero normals are as none, and opposed ones leave no hole") {
  for (const Bsdf& bsdf : kBsdfs) {
    const Scene flat = ball(bsdf.material(0.7f, 0));
    Scene zero = flat;
    giveNormals(zero, [](const Vec3&, int) { return Vec3(0); });
    checkScene(zero);
    const Image image = pictureOf(flat);
    const Image with_zero = pictureOf(zero);
    int different = 0;
    for (std::size_t i = 0; i < image.pixels.size(); ++i)
      different += image.pixels[i] != with_zero.pixels[i];
    checkAtMost("shading", fmt::format("zero normals, {}", bsdf.name),
                "pixels that differ from flat shading", different, 0);

    Scene opposed = flat;  // somewhere on every triangle the interpolated normal is zero
    giveNormals(opposed, [](const Vec3& n, int corner) { return corner % 2 == 0 ? n : -n; });
    const double mean = meanRadiance(pictureOf(opposed));
    checkAtMost("shading", fmt::format("opposed normals, {}", bsdf.name),
                "mean radiance, of flat shading's", mean / meanRadiance(image), 1.02);
  }
}

TEST_CASE("the winding of a two-sided surface does not show") {
  for (const Bsdf& bsdf : kBsdfs)
    for (const bool smooth : {false, true}) {
      Scene scene = ball(bsdf.material(0.7f, 0));
      if (smooth) giveNormals(scene, [](const Vec3& normal, int) { return normal; });
      Scene flipped = scene;
      flipWinding(flipped);
      // Blocks of these pictures are noisy by about a hundredth.
      checkAtMost("shading",
                  fmt::format("flipped winding, {}{}", bsdf.name, smooth ? ", with normals" : ""),
                  "largest difference of 8 x 8 pixels, relative to the mean",
                  blockDifference(pictureOf(scene), pictureOf(flipped)), 0.05);
    }
}
