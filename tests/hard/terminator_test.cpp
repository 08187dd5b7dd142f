// Where a coarse ball with smooth normals turns away from the light, its facets cut the light off
// before the normals do. Measured against a ball of 32,768 triangles.
#include <fmt/format.h>

#include <catch2/catch.hpp>
#include <cmath>

#include "tests/hard/bsdfs.h"
#include "tests/hard/hard_case.h"
#include "tests/hard/hard_picture.h"
#include "tests/image/pictures.h"

using namespace glimt;
using namespace glimt::test;

namespace {

// Along no axis of the ball's, so that no edge happens to be the terminator.
const glm::dvec3 kToLight = glm::normalize(glm::dvec3(0.8, 0.5, 0.33));

constexpr float kEye = 10;   // from the centre of the ball
constexpr float kView = 12;  // degrees

// A ball of radius 1 under a small distant light.
Scene ball(const Bsdf& bsdf, int levels) {
  Scene scene;
  addSphere(scene, 1, levels, add(scene, bsdf.material(0.8f, 0)));
  for (Triangle& triangle : scene.triangles)
    for (std::size_t corner = 0; corner < 3; ++corner) {
      triangle.normals[corner] = static_cast<std::uint32_t>(scene.normals.size());
      scene.normals.push_back(glm::normalize(scene.positions[triangle.positions[corner]]));
    }
  const std::uint32_t light = add(scene, lambert("light", Vec3(0), Vec3(1e4f)));
  const Vec3 across = Vec3(glm::normalize(glm::cross(kToLight, glm::dvec3(0, 1, 0))));
  const Vec3 up = glm::cross(Vec3(kToLight), across);
  addQuad(scene, 100.0f * Vec3(kToLight), across, up, light);
  scene.camera.position = Vec3(0, 0, kEye);
  scene.camera.target = Vec3(0);
  scene.camera.vertical_fov = kView;
  return scene;
}

// The cosine at which light comes in where a pixel sees the ball; -1 where it does not, or close to
// the outline, where a coarse ball has another shape.
double cosineAt(int x, int y, int size) {
  const double scale = std::tan(0.5 * kView * std::acos(-1.0) / 180);
  const glm::dvec3 direction = glm::normalize(
      glm::dvec3(((x + 0.5) / size * 2 - 1) * scale, (1 - (y + 0.5) / size * 2) * scale, -1));
  const glm::dvec3 eye(0, 0, kEye);
  const double along = glm::dot(eye, direction);
  const double root = along * along - kEye * kEye + 1;
  if (root < 0.3) return -1;
  return glm::dot(eye + (-along - std::sqrt(root)) * direction, kToLight);
}

struct Band {
  double rms = 0;    // difference of two pictures, relative to what is reflected of straight light
  double black = 0;  // share of its pixels that get no light in the first picture
};

// Where light comes in at 3 to 17 degrees over the surface of the fine ball.
Band bandOf(const Image& image, const Image& fine) {
  Band band;
  double straight = 0;
  int count = 0;
  for (int y = 0; y < image.height; ++y)
    for (int x = 0; x < image.width; ++x) {
      const auto at = static_cast<std::size_t>(y * image.width + x);
      const double cosine = cosineAt(x, y, image.width);
      if (cosine > 0.6) straight = std::max(straight, fine.pixels[at].g / cosine);
      if (cosine < 0.05 || cosine > 0.3) continue;
      band.rms += std::pow(image.pixels[at].g - fine.pixels[at].g, 2);
      band.black += image.pixels[at].g == 0;
      ++count;
    }
  band.rms = std::sqrt(band.rms / count) / straight;
  band.black /= count;
  return band;
}

}  // namespace

TEST_CASE("the terminator of a coarse ball lies where that of a fine one does") {
  const RenderSettings settings = settingsFor(slowDriver() ? 48 : 96, 0);
  const int samples = slowDriver() ? 16 : 64;
  for (const Bsdf& bsdf : kBsdfs) {
    const Image fine = hardPicture(ball(bsdf, 6), settings, samples);
    for (const int levels : {2, 3}) {
      const std::string name =
          fmt::format("terminator of {} triangles, {}", 8 << (2 * levels), bsdf.name);
      const Band band = bandOf(hardPicture(ball(bsdf, levels), settings, samples), fine);
      checkAtMost("shading", name, "pixels beside it without light, share", band.black, 0);
      // The normals of a coarse ball are those of a fine one in other places.
      checkAtMost("shading", name, "RMS difference beside it, of straight light", band.rms, 0.02);
    }
  }
}
