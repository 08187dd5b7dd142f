// Lens and parallel projection, from geometry.
#include <catch2/catch.hpp>

#include <cmath>
#include <vector>

#include "tests/image/pictures.h"
#include "tests/image/scenes.h"

using namespace glimt;
using namespace glimt::test;

namespace {

constexpr int kSize = 64;
constexpr float kFocus = 2;
constexpr float kAperture = 0.1f;

// A square light of three pixels a side on the axis at that distance, seen through a lens.
Scene lightAt(float distance, int blades) {
  Scene scene;
  Camera& camera = scene.camera;
  camera.position = Vec3(0);
  camera.target = Vec3(0, 0, -1);
  camera.vertical_fov = 40;
  camera.aperture_radius = kAperture;
  camera.focus_distance = kFocus;
  camera.aperture_blades = blades;
  const float half = 3 * distance * std::tan(glm::radians(20.0f)) / kSize;
  addQuad(scene, Vec3(-half, -half, -distance), Vec3(2 * half, 0, 0), Vec3(0, 2 * half, 0),
          add(scene, lambert("light", Vec3(0), Vec3(1))));
  return scene;
}

struct Spread {
  double light = 0;     // in pixels of radiance 1
  double variance = 0;  // of where it is, in pixels squared, mean of both axes
};

Spread spreadOf(const Image& image) {
  Spread spread;
  for (int y = 0; y < image.height; ++y)
    for (int x = 0; x < image.width; ++x) {
      const double weight =
          static_cast<double>(image.pixels[static_cast<std::size_t>(y * image.width + x)].g);
      const double u = x + 0.5 - kSize / 2.0;
      const double v = y + 0.5 - kSize / 2.0;
      spread.light += weight;
      spread.variance += weight * (u * u + v * v) / 2;
    }
  spread.variance /= spread.light;
  return spread;
}

}  // namespace

TEST_CASE("out of focus a point becomes a picture of the lens, as large as geometry says") {
  const int blades = GENERATE(0, 6);
  const float distance = GENERATE(1.2f, 4.0f);
  const Spread spread = spreadOf(render(lightAt(distance, blades), settingsFor(kSize, 0), 512));
  const double pixels_per_metre = kSize / (2 * kFocus * std::tan(20 * 3.14159265358979 / 180));
  const double radius =
      pixels_per_metre * static_cast<double>(kAperture * std::abs(1 - kFocus / distance));
  // Of a disk a quarter of its radius squared; of a hexagon five twenty-fourths.
  const double of_lens = radius * radius * (blades == 0 ? 0.25 : 2.5 / 12);
  // The light itself and the pixels are squares: a twelfth of the side squared.
  const double of_square = (9.0 + 1) / 12;
  INFO("blades " << blades << ", distance " << distance << ", radius " << radius);
  CHECK(std::sqrt(spread.variance) == Approx(std::sqrt(of_lens + of_square)).epsilon(0.04));
  CHECK(spread.light == Approx(9).epsilon(0.05));
}

TEST_CASE("in focus a lens shows what a pinhole shows") {
  Scene scene = lightAt(kFocus, 0);
  const Spread sharp = spreadOf(render(scene, settingsFor(kSize, 0), 128));
  scene.camera.aperture_radius = 0;
  const Spread pinhole = spreadOf(render(scene, settingsFor(kSize, 0), 128));
  CHECK(sharp.variance == Approx(pinhole.variance).epsilon(0.02));
  CHECK(sharp.light == Approx(pinhole.light).epsilon(0.02));
}

TEST_CASE("a parallel projection shows a size as it is, at every distance and aspect") {
  const float distance = GENERATE(1.0f, 50.0f);
  const int width = GENERATE(64, 128);
  Scene scene;
  addQuad(scene, Vec3(-0.5f, -0.5f, -distance), Vec3(1, 0, 0), Vec3(0, 1, 0),
          add(scene, lambert("square", Vec3(0), Vec3(1))));
  scene.camera.position = Vec3(0);
  scene.camera.target = Vec3(0, 0, -1);
  scene.camera.orthographic_height = 2;
  RenderSettings settings = settingsFor(kSize, 0);
  settings.width = width;
  const Image image = render(scene, settings, 4);
  for (int y = 0; y < kSize; ++y)
    for (int x = 0; x < width; ++x) {
      const bool inside = std::abs(x + 0.5 - width / 2.0) < 16 && std::abs(y + 0.5 - 32) < 16;
      const float seen = image.pixels[static_cast<std::size_t>(y * width + x)].g;
      REQUIRE(seen == Approx(inside ? 1 : 0).margin(1 / 128.0));  // of the packed record
    }
}

TEST_CASE("a camera that is exchanged while rendering brings its lens or projection along") {
  const Scene lens = lightAt(4, 0);
  Scene parallel = lens;
  parallel.camera.orthographic_height = 1;
  Scene pinhole = lens;
  pinhole.camera.aperture_radius = 0;
  const std::vector<Scene> scenes{lens, parallel, pinhole, lens};
  std::vector<Image> expected;
  for (const Scene& scene : scenes) expected.push_back(render(scene, settingsFor(kSize, 0), 1));
  ContextHandle context = createOffscreenContext(Backend::egl, 2);
  Renderer renderer(context, pinhole, settingsFor(kSize, 0));
  for (std::size_t i = 0; i < scenes.size(); ++i) {
    renderer.setCamera(scenes[i].camera);
    renderer.renderSample();
    CHECK(identical(renderer.radiance(), expected[i]));
  }
}
