// What a picture leaves out is said to be what it leaves out.
#include <catch2/catch.hpp>

#include <cmath>

#include "renderer/core/image_difference.h"
#include "renderer/limit_error.h"
#include "tests/image/pictures.h"
#include "tests/image/scenes.h"

using namespace glimt;
using namespace glimt::test;

namespace {

// What errors are relative to in a picture of one colour; see NoiseEstimate.
const double kOfEven = std::sqrt(1 + 1.0 / 16);

LimitError limitsOf(const Scene& scene, const RenderSettings& settings, double noise) {
  ContextHandle context = createOffscreenContext(Backend::egl, 2);
  Renderer renderer(context, scene, settings);
  constexpr double kSeconds = 1e6;  // as many samples as there may be
  return measureLimits(renderer, settings, noise, kSeconds);
}

// A panel of that luminance that fills the picture, and no other light.
Scene panel(float luminance) {
  Scene scene;
  addQuad(scene, Vec3(-2, -2, 0), Vec3(4, 0, 0), Vec3(0, 4, 0),
          add(scene, lambert("panel", Vec3(0), Vec3(luminance))));
  scene.camera.position = Vec3(0, 0, 2);
  return scene;
}

}  // namespace

TEST_CASE("what a limit on bounces leaves out of a closed cube is the rest of its geometric sum") {
  const int bounces = GENERATE(0, 3);
  const double rest = 1 - furnaceRadiance(0.5, bounces) / 2;
  const auto limitsWith = [&](std::uint32_t seed) {
    return limitsOf(furnace(0.5f), settingsFor(96, bounces, seed), 0.01);
  };
  CAPTURE(bounces, rest);
  const LimitError limits = limitsWith(1);
  const LimitError second = limitsWith(2);
  const LimitError third = limitsWith(3);
  CHECK(middleOf({limits.light, second.light, third.light}) == Approx(rest).epsilon(0.05));
  CHECK(middleOf({limits.truncation, second.truncation, third.truncation}) ==
        Approx(rest / kOfEven).epsilon(0.08));
  CHECK(limits.both == limits.truncation);
  CHECK(limits.clamp == 0);
}

TEST_CASE("enough bounces leave out less than the noise, and one less leaves out more") {
  constexpr double kNoise = 0.02;
  const LimitError limits = limitsOf(furnace(0.5f), settingsFor(96, 0), kNoise);
  const auto left = [](int bounces) { return (1 - furnaceRadiance(0.5, bounces) / 2) / kOfEven; };
  CHECK(left(limits.enough_bounces) < 1.1 * kNoise);
  CHECK(left(limits.enough_bounces - 1) > 0.9 * kNoise);
}

TEST_CASE("a scene of one surface loses nothing to a limit on bounces") {
  const LimitError limits = limitsOf(panel(3), settingsFor(64, 2), 0.01);
  CHECK(limits.truncation == 0);
  CHECK(limits.enough_bounces == 2);
}

TEST_CASE("a clamp takes what is above it, and that is said") {
  RenderSettings settings = settingsFor(64, 0);
  settings.clamp = 2;
  const Image clamped = render(panel(5), settings, 4);
  CHECK(meanOf(clamped).g == Approx(2).epsilon(1e-5));
  const LimitError limits = limitsOf(panel(5), settings, 0.01);
  CHECK(limits.clamp == Approx((5 - 2) / 5.0 / kOfEven).epsilon(1e-3));
  CHECK(limits.light == Approx(0.6).epsilon(1e-3));
  const Image below = render(panel(1.5f), settings, 4);
  CHECK(meanOf(below).g == Approx(1.5).epsilon(1e-5));
}

TEST_CASE("what a clamp takes of a small lamp beside the dark is what the picture lacks") {
  Scene scene = panel(0.2f);
  addQuad(scene, Vec3(-0.2f, -0.2f, 0.1f), Vec3(0.4f, 0, 0), Vec3(0, 0.4f, 0),
          add(scene, lambert("lamp", Vec3(0), Vec3(20))));
  RenderSettings settings = settingsFor(256, 0);
  const Image whole = render(scene, settings, 4);
  settings.clamp = 1;
  const Image clamped = render(scene, settings, 4);
  const double lacking = differenceOf(clamped, whole).noise;
  REQUIRE(lacking > 0.1);
  CHECK(limitsOf(scene, settings, 0.01).clamp == Approx(lacking).epsilon(0.15));
}

TEST_CASE("a clamped sample keeps its colour") {
  RenderSettings settings = settingsFor(16, 0);
  settings.clamp = 1;
  Scene scene = panel(0);
  scene.materials.front().emission = Vec3(8, 4, 2);
  const glm::dvec3 mean = meanOf(render(scene, settings, 4));
  CHECK(mean.r == Approx(2 * mean.g).epsilon(1e-5));
  CHECK(mean.g == Approx(2 * mean.b).epsilon(1e-5));
  CHECK(glm::dot(mean, glm::dvec3(0.2126, 0.7152, 0.0722)) == Approx(1).epsilon(1e-5));
}

TEST_CASE("after other limits and random numbers a renderer begins again, as one made with them") {
  const Scene scene = furnace(0.5f);
  ContextHandle context = createOffscreenContext(Backend::egl, 2);
  RenderSettings settings = settingsFor(32, 3, 7);
  settings.traversal = "octant-ahead";
  Image made;
  {
    Renderer renderer(context, scene, settings);
    for (int i = 0; i < 4; ++i) renderer.renderSample();
    made = renderer.radiance();
  }
  RenderSettings other = settings;
  other.bounces = 1;
  other.seed = 8;
  Renderer renderer(context, scene, other);
  for (int i = 0; i < 3; ++i) renderer.renderSample();
  renderer.setLimits({3, {}});
  renderer.setSampler(Sampler::sobol, 7);
  CHECK(renderer.samples() == 0);
  for (int i = 0; i < 4; ++i) renderer.renderSample();
  CHECK(identical(renderer.radiance(), made));
}
