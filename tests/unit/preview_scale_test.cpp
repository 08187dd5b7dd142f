#include "app/viewer/preview_scale.h"

#include <catch2/catch.hpp>

using namespace glimt;

namespace {

// As after a while on a device with that speed.
PreviewScale used(double seconds_per_pixel) {
  PreviewScale scale;
  for (int i = 0; i < 20; ++i) scale.learn(1000, 1000 * seconds_per_pixel);
  return scale;
}

}  // namespace

TEST_CASE("previews are in full where samples are fast") {
  CHECK(used(1e-8).divisorFor(1'000'000) == 1);
}

TEST_CASE("a sample of a preview takes less than 50 ms") {
  for (const double seconds : {0.06, 0.1, 0.3, 1.0, 3.0}) {
    PreviewScale scale = used(seconds / 1'000'000);
    const int divisor = scale.divisorFor(1'000'000);
    CHECK(divisor > 1);
    CHECK(seconds / (divisor * divisor) < 0.05);
  }
}

TEST_CASE("previews keep something to see on the slowest device") {
  CHECK(used(1).divisorFor(1'000'000) == 16);
}

TEST_CASE("the first sample, which compiles, says nothing") {
  PreviewScale scale;
  const int before = scale.divisorFor(1'000'000);
  scale.learn(1000, 10);
  CHECK(scale.divisorFor(1'000'000) == before);
  scale.learn(1000, 1e-5);
  CHECK(scale.divisorFor(1'000'000) == 1);
}

TEST_CASE("small changes of speed leave the size alone") {
  PreviewScale scale = used(0.3e-6);
  const int before = scale.divisorFor(1'000'000);
  for (int i = 0; i < 20; ++i) scale.learn(1000, 1000 * 0.33e-6);
  CHECK(scale.divisorFor(1'000'000) == before);
  for (int i = 0; i < 20; ++i) scale.learn(1000, 1000 * 0.27e-6);
  CHECK(scale.divisorFor(1'000'000) == before);
}
