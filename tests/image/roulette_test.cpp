// Russian roulette saves rays, and takes no light.
#include <catch2/catch.hpp>

#include "tests/image/pictures.h"
#include "tests/image/scenes.h"

using namespace glimt;
using namespace glimt::test;

namespace {

struct Outcome {
  double mean;
  double bounce_rays;
};

Outcome outcomeOf(bool roulette, int bounces, std::uint32_t seed = 1) {
  RenderSettings settings = settingsFor(64, bounces, seed);
  settings.roulette = roulette;
  ContextHandle context = createOffscreenContext(Backend::egl, 2);
  Renderer renderer(context, furnace(0.5f), settings);
  while (renderer.samples() < 32) renderer.renderSample();
  return {meanOf(renderer.radiance()).g, renderer.statistics().bounce_rays};
}

}  // namespace

TEST_CASE("roulette ends weak paths, and what is left has the light of all") {
  constexpr int kBounces = 8;
  const Outcome all = outcomeOf(false, kBounces);
  const Outcome left = outcomeOf(true, kBounces);
  const auto mean_with = [](std::uint32_t seed) { return outcomeOf(false, kBounces, seed).mean; };
  CHECK(middleOf({all.mean, mean_with(2), mean_with(3)}) ==
        Approx(furnaceRadiance(0.5, kBounces)).epsilon(1e-4));
  CHECK(left.mean == Approx(all.mean).epsilon(1e-3));
  // Two bounces of a half weaken no path; of the others each halves what is left. The ray that a
  // path ends instead of is still counted.
  CHECK(left.bounce_rays / all.bounce_rays == Approx((3 + 31.0 / 32) / kBounces).epsilon(0.02));
}

TEST_CASE("roulette ends no path at its first bounce") {
  CHECK(outcomeOf(true, 1).bounce_rays == outcomeOf(false, 1).bounce_rays);
}
