// Where random numbers come from decides how fast a picture gets better, not what it becomes.
#include <catch2/catch.hpp>

#include "renderer/core/image_difference.h"
#include "tests/image/pictures.h"
#include "tests/image/scenes.h"

using namespace glimt;
using namespace glimt::test;

TEST_CASE("random numbers and low-discrepancy points agree, and these are more exact") {
  const Scene scene = furnace(0.5f);
  const Image converged = render(scene, settingsFor(32, 1, 99), 4096);
  RenderSettings random = settingsFor(32, 1);
  random.sampler = Sampler::random;
  const Image of_random = render(scene, random, 256);
  const Image of_sobol = render(scene, settingsFor(32, 1), 256);
  CHECK(meanOf(of_random).g == Approx(meanOf(converged).g).epsilon(0.01));
  CHECK(differenceOf(of_sobol, converged).noise < 0.8 * differenceOf(of_random, converged).noise);
}
