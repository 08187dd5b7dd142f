// What a renderer keeps and tells beside the radiance: first hits, spread, the length of paths; and
// samples that begin in the middle of the sequence.
#include <catch2/catch.hpp>

#include <cmath>

#include "tests/image/pictures.h"
#include "tests/image/scenes.h"

using namespace glimt;
using namespace glimt::test;

namespace {

constexpr int kSide = 16;

// A card in the left half of the picture, four metres away.
Scene card() {
  Scene scene;
  add(scene, lambert("unused", Vec3(0)));
  addQuad(scene, Vec3(-4, -4, 0), Vec3(4, 0, 0), Vec3(0, 8, 0),
          add(scene, lambert("card", Vec3(0.75f, 0.5f, 0.25f))));
  scene.environment.color = Vec3(1);
  scene.camera.position = Vec3(0, 0, 4);
  return scene;
}

Picture pictureOf(Renderer& renderer, int samples) {
  while (renderer.samples() < samples) renderer.renderSample();
  return renderer.picture();
}

Picture pictureOf(const Scene& scene, const RenderSettings& settings, int samples) {
  ContextHandle context = createOffscreenContext(Backend::egl, 2);
  Renderer renderer(context, scene, settings);
  return pictureOf(renderer, samples);
}

}  // namespace

TEST_CASE("first hits are the colour, the normal, the depth and the material of what is seen") {
  ContextHandle context = createOffscreenContext(Backend::egl, 2);
  Renderer renderer(context, card(), settingsFor(kSide, 1));
  const FirstHits hits = renderer.firstHits(4);
  for (std::size_t i = 0; i < kSide * kSide; ++i) {
    const bool covered = i % kSide < kSide / 2;
    CAPTURE(i);
    CHECK(hits.coverage[i] == (covered ? 1 : 0));
    CHECK(hits.material[i] == (covered ? 2 : 0));
    CHECK(glm::distance(hits.albedo[i], covered ? Vec3(0.75f, 0.5f, 0.25f) : Vec3(0)) < 1e-6f);
    CHECK(glm::distance(hits.normal[i], covered ? Vec3(0, 0, 1) : Vec3(0)) < 1e-6f);
    // Along the view, not along the ray.
    CHECK(hits.depth[i] == Approx(covered ? 4 : 0).epsilon(1e-4));
  }
}

TEST_CASE("asking for first hits leaves the picture as it is, and what is added to it") {
  const Image alone = pictureOf(card(), settingsFor(kSide, 2), 6).radiance;
  ContextHandle context = createOffscreenContext(Backend::egl, 2);
  Renderer renderer(context, card(), settingsFor(kSide, 2));
  const Image before = pictureOf(renderer, 3).radiance;
  renderer.firstHits(2);
  CHECK(identical(renderer.radiance(), before));
  CHECK(identical(pictureOf(renderer, 6).radiance, alone));
}

TEST_CASE("the spread is the standard deviation of the samples' luminance") {
  // One pixel, half of it white.
  Scene scene;
  addQuad(scene, Vec3(-4, -4, 0), Vec3(4, 0, 0), Vec3(0, 8, 0),
          add(scene, lambert("lamp", Vec3(0), Vec3(1))));
  scene.camera.position = Vec3(0, 0, 4);
  RenderSettings settings = settingsFor(1, 0);
  settings.keep_spread = true;
  const Picture picture = pictureOf(scene, settings, 64);
  const double share = picture.radiance.pixels[0].g;
  CHECK(share == Approx(0.5).margin(0.05));
  CHECK(picture.spread[0] == Approx(std::sqrt(share * (1 - share))).epsilon(1e-3));
  CHECK(picture.pixel_samples[0] == 64);
}

TEST_CASE("what is kept beside the radiance changes nothing of it") {
  RenderSettings settings = settingsFor(kSide, 2);
  const Image plain = pictureOf(card(), settings, 4).radiance;
  settings.keep_spread = true;
  settings.keep_path_lengths = true;
  CHECK(identical(pictureOf(card(), settings, 4).radiance, plain));
}

TEST_CASE("a path's length is the number of surfaces that it has met") {
  RenderSettings settings = settingsFor(kSide, 3);
  settings.keep_path_lengths = true;
  settings.roulette = false;  // all paths of the furnace are equally long
  for (const float length : pictureOf(furnace(0.5f), settings, 2).path_lengths) CHECK(length == 4);
  const Picture open = pictureOf(card(), settings, 2);
  CHECK(open.path_lengths[0] == 1);
  CHECK(open.path_lengths[kSide - 1] == 0);
}

TEST_CASE("two halves of a sequence, from two renderers, are the whole of it") {
  RenderSettings settings = settingsFor(kSide, 2);
  const Image whole = pictureOf(card(), settings, 8).radiance;
  const Image first = pictureOf(card(), settings, 4).radiance;
  settings.first_sample = 4;
  const Image second = pictureOf(card(), settings, 4).radiance;
  CHECK_FALSE(identical(first, second));
  for (std::size_t i = 0; i < whole.pixels.size(); ++i) {
    const Vec3 mean = 0.5f * first.pixels[i] + 0.5f * second.pixels[i];
    CHECK(glm::distance(mean, whole.pixels[i]) <= 1e-6f * glm::length(whole.pixels[i]));
  }
}
