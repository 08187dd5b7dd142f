// Closed rooms whose every surface emits 1 and reflects the share a: after B bounces each pixel
// holds the sum of a^k for k = 0 to B + 1, whatever the shape of the room.
#include <fmt/format.h>

#include <algorithm>
#include <catch2/catch.hpp>

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

double worstError(const Scene& scene, float albedo, int most_samples) {
  double worst = 0;
  for (const int bounces : {1, 4, 16, 64}) {
    // The last surface samples lights only, which is noisy in corners: more samples where there are
    // few surfaces before it. Fewer would not do, so slow drivers take their time.
    const int samples = std::max(most_samples / bounces, 8);
    const Image image = hardPicture(scene, settingsFor(32, bounces), samples);
    worst = std::max(worst, relativeError(meanRadiance(image), furnaceRadiance(albedo, bounces)));
  }
  return worst;
}

}  // namespace

TEST_CASE("a closed room that emits and reflects holds the sum of its bounces") {
  for (const Bsdf& bsdf : kBsdfs)
    for (const float albedo : {1.0f, 0.5f}) {
      const std::string name = fmt::format("furnace, {}, albedo {}", bsdf.name, albedo);
      const std::string what = "mean after 1 to 64 bounces, worst relative error";
      const Material wall = bsdf.material(albedo, 1);
      checkAtMost("shading", name + ", box", what,
                  worstError(box(wall), albedo, albedo > 0.9f ? 1536 : 512), 0.005);
      checkAtMost("shading", name + ", sphere", what, worstError(sphere(wall), albedo, 64), 0.005);
    }
}
