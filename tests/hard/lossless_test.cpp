// White furnaces of surfaces that lose no light, be it reflected by a mirror, by facets or by
// layers, or let through by glass.
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

// Fewer pixels or samples would be too noisy for the bounds, so slow drivers take their time.
constexpr int kSize = 32;

Scene closedBall(const LosslessBsdf& bsdf) {
  Scene scene;
  addSphere(scene, 1, 3, add(scene, bsdf.material(1)));
  scene.camera = furnace(0).camera;
  scene.camera.position *= 0.5f;
  return scene;
}

// A ball that fills the picture.
Scene ballOutside(const LosslessBsdf& bsdf) {
  Scene scene;
  addSphere(scene, 1, 3, add(scene, bsdf.material(0)));
  scene.camera.position = Vec3(0, 0, 3);
  scene.camera.vertical_fov = 20;
  return scene;
}

double closedError(const Scene& scene, int bounces, int samples) {
  const Image image = hardPicture(scene, settingsFor(kSize, bounces), samples);
  return relativeError(meanRadiance(image), furnaceRadiance(1, bounces));
}

// The weights of paths through rough glass differ by as much as what they are a mean of: of 18
// times as many the mean's deviation is 0.1%.
double outsideError(const Scene& scene) {
  const bool rough = scene.materials.front().roughness > 0.5f;
  const Image image = rough ? hardPicture(scene, settingsFor(3 * kSize, 64), 128)
                            : hardPicture(scene, settingsFor(kSize, 64), 64);
  return relativeError(meanRadiance(image), 1);
}

}  // namespace

// What of the table's half a percent concerns a direction counts with every bounce, and so does the
// noise: the weights of a path multiply, for rough metal to a few hundred in 16 bounces.
TEST_CASE("a closed ball of any white reflector holds one more with each bounce") {
  for (const LosslessBsdf& bsdf : kReflectors) {
    double worst = 0;
    for (const int bounces : {1, 4})
      worst = std::max(worst, closedError(closedBall(bsdf), bounces, 128));
    checkAtMost("shading", fmt::format("furnace, {}, ball", bsdf.name),
                "mean after 1 and 4 bounces, worst relative error", worst, 0.005);
  }
}

TEST_CASE("mirrors lose no light over 64 bounces") {
  checkAtMost("shading", "furnace, mirror, ball", "mean after 64 bounces, relative error",
              closedError(closedBall(kReflectors[0]), 64, 8), 1e-5);
}

TEST_CASE("a ball of any glass is as bright as an even sky or an even room around it") {
  for (const LosslessBsdf& bsdf : kGlasses) {
    Scene sky = ballOutside(bsdf);
    sky.environment.color = Vec3(1);
    checkAtMost("shading", fmt::format("ball under an even sky, {}", bsdf.name),
                "mean after 64 bounces, relative error", outsideError(sky), 0.005);
    if (slowDriver()) continue;
    Scene room = ballOutside(bsdf);
    addCube(room, 4, add(room, lambert("room", Vec3(0), Vec3(1))), true);
    checkAtMost("shading", fmt::format("ball in an even room, {}", bsdf.name),
                "mean after 64 bounces, relative error", outsideError(room), 0.005);
  }
}
