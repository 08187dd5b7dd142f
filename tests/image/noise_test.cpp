// How wrong a picture is said to be is how wrong it is.
#include <catch2/catch.hpp>

#include "app/sampling.h"
#include "renderer/core/image_difference.h"
#include "tests/image/pictures.h"
#include "tests/image/scenes.h"

using namespace glimt;
using namespace glimt::test;

namespace {

// A ball on a floor under a small light: soft shadows, and light from surface to surface.
Scene ballOnFloor() {
  Scene scene;
  addQuad(scene, Vec3(-3, -1, 3), Vec3(6, 0, 0), Vec3(0, 0, -6),
          add(scene, lambert("floor", Vec3(0.6f, 0.7f, 0.8f))));
  addQuad(scene, Vec3(-0.5f, 2.5f, -0.5f), Vec3(1, 0, 0), Vec3(0, 0, 1),
          add(scene, lambert("light", Vec3(0), Vec3(12, 10, 8))));
  addSphere(scene, 1, 2, add(scene, lambert("ball", Vec3(0.8f, 0.3f, 0.2f))));
  scene.environment.color = Vec3(0.05f);
  scene.camera.position = Vec3(2, 1.5f, 4);
  return scene;
}

constexpr int kSide = 64;

RenderSettings settings(std::uint32_t seed) {
  RenderSettings settings = settingsFor(kSide, 3, seed);
  settings.traversal = "octant-ahead";
  return settings;
}

}  // namespace

TEST_CASE("the noise that is claimed is that against the converged picture") {
  const Image converged = render(ballOnFloor(), settings(1000), 2048);
  ContextHandle context = createOffscreenContext(Backend::egl, 2);
  double ratios = 0;
  int count = 0;
  int outside = 0;
  for (const std::uint32_t seed : {1u, 2u, 3u}) {
    Renderer renderer(context, ballOnFloor(), settings(seed));
    for (const int samples : {32, 50, 64, 150}) {
      CAPTURE(seed, samples);
      while (renderer.samples() < samples) renderer.renderSample();
      const std::optional<NoiseEstimate> noise = renderer.noiseNow();
      REQUIRE(noise);
      CHECK(noise->samples == samples);
      const double truth = differenceOf(renderer.radiance(), converged).noise;
      if (noise->upper < truth || noise->lower > truth) ++outside;
      ratios += noise->relative / truth;
      ++count;
    }
  }
  CHECK(ratios / count == Approx(1).epsilon(0.1));
  CHECK(outside <= 1);  // a tenth of them
}

TEST_CASE("nothing is claimed of a picture of few samples, and of another picture all anew") {
  ContextHandle context = createOffscreenContext(Backend::egl, 2);
  Renderer renderer(context, ballOnFloor(), settings(1));
  while (renderer.samples() < 7) renderer.renderSample();
  CHECK_FALSE(renderer.noiseNow());
  renderer.renderSample();
  CHECK(renderer.noiseNow());
  renderer.setCamera(ballOnFloor().camera);
  CHECK_FALSE(renderer.noiseNow());
}

TEST_CASE("a render to a noise ends when the noise is below it, and not long after") {
  ContextHandle context = createOffscreenContext(Backend::egl, 2);
  Renderer renderer(context, ballOnFloor(), settings(1));
  const Interrupt interrupt;
  Progress progress(false);
  constexpr double kGoal = 0.03;
  const Sampling sampling = sampleUntil(renderer, {5000, {}, kGoal}, interrupt, progress);
  CHECK(sampling.ended_by == EndedBy::noise);
  REQUIRE(sampling.noise);
  CHECK(sampling.noise->upper <= kGoal);
  CHECK(sampling.noise->upper > 0.85 * kGoal);
  CHECK(sampling.samples == sampling.noise->samples);
}

TEST_CASE("a picture of an environment of one colour has no noise but rounding") {
  ContextHandle context = createOffscreenContext(Backend::egl, 2);
  Scene scene;
  scene.environment.color = Vec3(0.5f);
  Renderer renderer(context, scene, settings(1));
  while (renderer.samples() < 20) renderer.renderSample();
  const std::optional<NoiseEstimate> noise = renderer.noiseNow();
  REQUIRE(noise);
  CHECK(noise->upper < 1e-4);
}

TEST_CASE("where calm parts rest, fewer samples give the noise that was asked for") {
  constexpr double kGoal = 0.04;
  RenderSettings large = settings(1000);
  large.width = large.height = 2 * kSide;
  const Image converged = render(ballOnFloor(), large, 512);
  large.seed = 1;
  ContextHandle context = createOffscreenContext(Backend::egl, 2);
  Renderer renderer(context, ballOnFloor(), large);
  renderer.restBelow(kGoal);
  std::optional<NoiseEstimate> noise;
  do {
    renderer.renderSample();
    noise = renderer.noiseNow();
  } while ((!noise || noise->upper > kGoal) && renderer.samples() < 2048);
  const Picture picture = renderer.picture();
  CHECK(picture.nonfinite_pixels == 0);
  CHECK(picture.mean_samples < 0.95 * picture.samples);
  CHECK(noise->resting > 0);
  const ImageDifference difference = differenceOf(picture.radiance, converged);
  CHECK(difference.noise < kGoal);
  CHECK(difference.noise == Approx(noise->relative).epsilon(0.2));
  for (int channel = 0; channel < 3; ++channel)
    CHECK(difference.mean_ratio[channel] == Approx(1).margin(0.01));
}
