// Denoised pictures: less noise, and nothing lost that the samples are sure of.
#include <catch2/catch.hpp>

#include <cmath>
#include <stdexcept>

#include "renderer/core/image_difference.h"
#include "tests/image/pictures.h"
#include "tests/image/scenes.h"

using namespace glimt;
using namespace glimt::test;

namespace {

constexpr int kSide = 64;

// A floor of two colours under a small light and a dim sky, and a ball on it.
Scene twoColours() {
  Scene scene;
  addQuad(scene, Vec3(-3, -1, 3), Vec3(3, 0, 0), Vec3(0, 0, -6),
          add(scene, lambert("dark", Vec3(0.1f, 0.2f, 0.1f))));
  addQuad(scene, Vec3(0, -1, 3), Vec3(3, 0, 0), Vec3(0, 0, -6),
          add(scene, lambert("bright", Vec3(0.8f, 0.7f, 0.6f))));
  addQuad(scene, Vec3(-0.5f, 2.5f, -0.5f), Vec3(1, 0, 0), Vec3(0, 0, 1),
          add(scene, lambert("light", Vec3(0), Vec3(12, 10, 8))));
  addSphere(scene, 0.5f, 2, add(scene, lambert("ball", Vec3(0.8f, 0.3f, 0.2f))));
  scene.environment.color = Vec3(0.05f);
  scene.camera.position = Vec3(0, 2, 4);
  return scene;
}

RenderSettings settings(int side, std::uint32_t seed = 1) {
  RenderSettings settings = settingsFor(side, 3, seed);
  settings.keep_spread = true;
  return settings;
}

struct Pair {
  Picture noisy;
  Image denoised;
};

Pair picturesOf(const Scene& scene, const RenderSettings& settings, int samples) {
  ContextHandle context = createOffscreenContext(Backend::egl, 2);
  Renderer renderer(context, scene, settings);
  for (int i = 0; i < samples; ++i) renderer.renderSample();
  Pair pair;
  pair.denoised = renderer.denoised();
  pair.noisy = renderer.picture();
  return pair;
}

bool allFinite(const Image& image) {
  for (const Vec3& pixel : image.pixels)
    for (int channel = 0; channel < 3; ++channel)
      if (!std::isfinite(pixel[channel]) || pixel[channel] < 0) return false;
  return true;
}

}  // namespace

TEST_CASE("a denoised picture is far nearer to the converged one, and as bright") {
  const Image converged = render(twoColours(), settings(kSide, 1000), 256);
  const Pair pair = picturesOf(twoColours(), settings(kSide), 8);
  const ImageDifference before = differenceOf(pair.noisy.radiance, converged);
  const ImageDifference after = differenceOf(pair.denoised, converged);
  CAPTURE(before.relative_mse, after.relative_mse);
  CHECK(after.relative_mse < 0.5 * before.relative_mse);
  for (int channel = 0; channel < 3; ++channel)
    CHECK(after.mean_ratio[channel] == Approx(before.mean_ratio[channel]).epsilon(0.02));
}

TEST_CASE("a picture without noise is left as it is, to the last bit") {
  const Pair pair = picturesOf(furnace(0), settings(kSide), 8);
  CHECK(identical(pair.denoised, pair.noisy.radiance));
}

TEST_CASE("the environment behind all surfaces is left as it is, to the last bit") {
  const Pair pair = picturesOf(twoColours(), settings(kSide), 8);
  CHECK(pair.denoised.pixels.front() == pair.noisy.radiance.pixels.front());
  CHECK_FALSE(identical(pair.denoised, pair.noisy.radiance));
}

TEST_CASE("the edge between two colours stays sharp") {
  Scene scene = twoColours();
  scene.camera.position = Vec3(0.02f, 4, 0);
  scene.camera.target = Vec3(0.02f, 0, 0);
  scene.camera.up = Vec3(0, 0, -1);
  scene.camera.vertical_fov = 25;
  const Image converged = render(scene, settings(kSide, 1000), 256);
  const Image denoised = picturesOf(scene, settings(kSide), 8).denoised;
  // Columns beside the edge, over the floor below the ball's image.
  for (const int column : {kSide / 2 - 3, kSide / 2 - 2, kSide / 2 + 2, kSide / 2 + 3}) {
    double light = 0;
    double truth = 0;
    for (int row = 0; row < kSide; ++row) {
      const std::size_t i = static_cast<std::size_t>(row) * kSide + column;
      light += denoised.pixels[i].g;
      truth += converged.pixels[i].g;
    }
    CAPTURE(column);
    CHECK(light == Approx(truth).epsilon(0.04));
  }
}

TEST_CASE("the samples and what is said of their noise stay as they are, also for those to come") {
  ContextHandle context = createOffscreenContext(Backend::egl, 2);
  Renderer plain(context, twoColours(), settings(16));
  for (int i = 0; i < 12; ++i) plain.renderSample();
  const std::optional<NoiseEstimate> noise = plain.noiseNow();
  const Image image = plain.radiance();
  Renderer denoising(context, twoColours(), settings(16));
  for (int i = 0; i < 12; ++i) {
    denoising.renderSample();
    if (i % 5 == 2) denoising.denoised();
  }
  const Image denoised = denoising.denoised();
  CHECK(denoising.noiseNow()->relative == noise->relative);
  CHECK(identical(denoising.radiance(), image));
  CHECK(denoised.denoised);
  CHECK_FALSE(denoising.radiance().denoised);
}

TEST_CASE("a picture whose denoising is given up is denoised the next time as it would have been") {
  ContextHandle context = createOffscreenContext(Backend::egl, 2);
  Renderer renderer(context, twoColours(), settings(16));
  for (int i = 0; i < 8; ++i) renderer.renderSample();
  const Image denoised = renderer.denoised();
  for (const float share : {0.0f, 0.3f, 0.8f}) {
    CAPTURE(share);
    Renderer other(context, twoColours(), settings(16));
    for (int i = 0; i < 8; ++i) other.renderSample();
    const auto give_up = [share](float fraction) {
      if (fraction >= share) throw std::runtime_error("given up");
    };
    CHECK_THROWS_AS(other.denoised(give_up), std::runtime_error);
    CHECK(identical(other.denoised(), denoised));
  }
}

TEST_CASE("alpha is left as it is, and what is transparent stays black") {
  Scene scene = twoColours();
  scene.transparent_background = true;
  scene.materials[0].shadow_catcher = true;
  constexpr int kEnough = 32;  // for every pixel in which the ball is seen not to be black
  const Pair pair = picturesOf(scene, settings(kSide), kEnough);
  CHECK(pair.denoised.alpha == pair.noisy.radiance.alpha);
  for (std::size_t i = 0; i < pair.denoised.pixels.size(); ++i)
    if (pair.noisy.radiance.pixels[i] == Vec3(0)) CHECK(pair.denoised.pixels[i] == Vec3(0));
}

TEST_CASE("what a mirror shows is denoised as what is seen without it") {
  // Behind the ball, where the floor's two colours are seen again.
  Scene scene = twoColours();
  Material mirror = lambert("mirror", Vec3(1));
  mirror.metallic = 1;
  mirror.roughness = 0;
  addQuad(scene, Vec3(-3, -1, -3), Vec3(6, 0, 0), Vec3(0, 6, 0), add(scene, mirror));
  scene.camera.position = Vec3(0, 0.5f, 2.5f);
  scene.camera.target = Vec3(0, -0.5f, -3);
  scene.camera.vertical_fov = 20;
  const Image converged = render(scene, settings(kSide / 2, 1000), 256);
  const Pair pair = picturesOf(scene, settings(kSide / 2), 8);
  const double before = differenceOf(pair.noisy.radiance, converged).relative_mse;
  CHECK(differenceOf(pair.denoised, converged).relative_mse < 0.5 * before);
}

TEST_CASE("pictures of a single pixel, of one sample, and without a known spread are sound") {
  CHECK(allFinite(picturesOf(twoColours(), settings(1), 1).denoised));
  const Pair single = picturesOf(twoColours(), settings(kSide), 1);
  CHECK(allFinite(single.denoised));
  CHECK_FALSE(identical(single.denoised, single.noisy.radiance));
  RenderSettings unknown = settings(kSide);
  unknown.keep_spread = false;
  const Pair pair = picturesOf(twoColours(), unknown, 8);
  CHECK(allFinite(pair.denoised));
  CHECK_FALSE(identical(pair.denoised, pair.noisy.radiance));
}
