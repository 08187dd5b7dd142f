// Closed rooms whose every surface emits 1 and reflects the share a: after B bounces each pixel
// holds the sum of a^k for k = 0 to B + 1, whatever the shape of the room.
#include <fmt/format.h>

#include <algorithm>
#include <catch2/catch.hpp>
#include <vector>

#include "tests/hard/bsdfs.h"
#include "tests/hard/hard_case.h"
#include "tests/hard/hard_picture.h"
#include "tests/image/pictures.h"

using namespace glimt;
using namespace glimt::test;

namespace {

Scene box(const Material& wall) {
  Scene scene = furnace(0);
  scene.materials = {wall};
  return scene;
}

Scene sphere(const Material& wall) {
  Scene scene;
  addSphere(scene, 1, 3, add(scene, wall));
  scene.camera = furnace(0).camera;
  scene.camera.position *= 0.5f;
  return scene;
}

const std::string kWhat = "mean after 1 to 64 bounces, worst relative error";

std::string nameOf(const Bsdf& bsdf, float albedo) {
  return fmt::format("furnace, {}, albedo {}", bsdf.name, albedo);
}

double worstError(const Scene& scene, float albedo, int most_samples) {
  double worst = 0;
  const std::vector<int> all = {1, 4, 16, 64};
  const std::vector<int> ends = {1, 64};
  for (const int bounces : slowDriver() ? ends : all) {
    // The last surface samples lights only, which is noisy in corners: more samples where there are
    // few surfaces before it. Fewer would not do, so slow drivers take their time.
    const int samples = std::max(most_samples / bounces, 8);
    const auto mean = [&](std::uint32_t seed) {
      return meanRadiance(hardPicture(scene, settingsFor(32, bounces, seed), samples));
    };
    const double middle = middleOf({mean(1), mean(2), mean(3)});
    worst = std::max(worst, relativeError(middle, furnaceRadiance(albedo, bounces)));
  }
  return worst;
}

}  // namespace

TEST_CASE("a closed box that emits and reflects holds the sum of its bounces") {
  for (const Bsdf& bsdf : kBsdfs)
    for (const float albedo : {1.0f, 0.5f})
      checkAtMost("shading", nameOf(bsdf, albedo) + ", box", kWhat,
                  worstError(box(bsdf.material(albedo, 1)), albedo, albedo > 0.9f ? 512 : 192),
                  0.005);
}

TEST_CASE("a closed sphere that emits and reflects holds the sum of its bounces") {
  for (const Bsdf& bsdf : kBsdfs)
    for (const float albedo : {1.0f, 0.5f})
      checkAtMost("shading", nameOf(bsdf, albedo) + ", sphere", kWhat,
                  worstError(sphere(bsdf.material(albedo, 1)), albedo, 64), 0.005);
}
