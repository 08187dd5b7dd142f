// The noise that follows from a picture's changes.
#include "renderer/passes/noise.h"

#include <catch2/catch.hpp>
#include <cmath>
#include <utility>

using namespace glimt;

namespace {

// Pictures of many pixels whose variance falls as 1 / n + smooth / n^1.5, as changes between
// numbers of samples show it.
class Changes {
 public:
  explicit Changes(double smooth, double pixels = 1e5) : smooth_(smooth), pixels_(pixels) {}

  double variance(double samples) const { return 1 / samples + smooth_ / std::pow(samples, 1.5); }

  ChangeSums sums(int samples, int before) const {
    const double change = variance(before) - variance(samples);
    ChangeSums sums;
    sums.squares = pixels_ * change;
    sums.fourths = pixels_ * 3 * change * change;
    sums.squares_before = pixels_ * (variance(0.5 * before) - variance(before));
    sums.luminance = pixels_;
    sums.pixels = pixels_;
    return sums;
  }

  Noise after(int samples) const {
    Noise noise;
    for (int n = 2 * Noise::kFirst; n <= samples; n *= 2) noise.doubled(sums(n, n / 2), n);
    return noise;
  }

 private:
  double smooth_;
  double pixels_;
};

}  // namespace

TEST_CASE("the noise is known from changes, for independent and for low-discrepancy samples") {
  for (const double smooth : {0, 3, 10}) {
    CAPTURE(smooth);
    const Changes changes(smooth);
    const Noise noise = changes.after(256);
    for (const auto& [samples, before] : {std::pair{256, 128}, {300, 128}, {500, 128}}) {
      CAPTURE(samples);
      const NoiseEstimate estimate = noise.estimate(changes.sums(samples, before), samples, before);
      const double truth = std::sqrt(changes.variance(samples));
      CHECK(estimate.relative == Approx(truth).epsilon(0.07));
      CHECK(estimate.lower < truth);
      CHECK(estimate.upper > truth);
      CHECK(estimate.samples == samples);
    }
  }
}

TEST_CASE("how the noise falls is known better with each doubling, and so is the noise") {
  const Changes changes(1e6);
  double error = 1;
  double margin = 2;
  for (const int samples : {16, 32, 64, 128, 256}) {
    CAPTURE(samples);
    const NoiseEstimate estimate =
        changes.after(samples).estimate(changes.sums(samples, samples / 2), samples, samples / 2);
    CHECK(std::abs(estimate.exponent() - 1.5) < error);
    CHECK(estimate.upper / estimate.relative < margin);
    error = std::abs(estimate.exponent() - 1.5);
    margin = estimate.upper / estimate.relative;
  }
  CHECK(error < 0.1);
}

TEST_CASE("fewer pixels are less certain") {
  const Changes many(3, 1e6);
  const Changes few(3, 100);
  const auto margin = [](const Changes& changes) {
    const NoiseEstimate estimate = changes.after(64).estimate(changes.sums(64, 32), 64, 32);
    return estimate.upper / estimate.relative;
  };
  CHECK(margin(few) > 1.05 * margin(many));
}

TEST_CASE("the samples that a goal takes are those at which the noise is below it") {
  const Changes changes(0);
  const NoiseEstimate now = changes.after(512).estimate(changes.sums(512, 256), 512, 256);
  const int later = static_cast<int>(now.samplesFor(0.5 * now.upper));
  CHECK(std::sqrt(changes.variance(later)) == Approx(0.5 * now.relative).epsilon(0.06));
  CHECK(now.samplesFor(now.upper) <= 512);
  CHECK(now.samplesFor(now.upper) > 0.9 * 512);
}

TEST_CASE("a picture that does not change has no noise") {
  Noise noise;
  ChangeSums sums;
  sums.pixels = 100;
  noise.doubled(sums, 16);
  const NoiseEstimate estimate = noise.estimate(sums, 16, 8);
  CHECK(estimate.relative == 0);
  CHECK(estimate.upper == 0);
}
