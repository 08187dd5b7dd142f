// The noise that follows from a picture's changes.
#include "renderer/passes/noise.h"

#include <bit>
#include <catch2/catch.hpp>
#include <cmath>

using namespace glimt;

namespace {

// Pictures of many pixels whose variance falls as 1 / n + smooth / n^1.5, as changes between
// numbers of samples show it.
class Changes {
 public:
  explicit Changes(double smooth, double pixels = 1e5) : smooth_(smooth), pixels_(pixels) {}

  double variance(double samples) const { return 1 / samples + smooth_ / std::pow(samples, 1.5); }

  // At a doubling or after it.
  ChangeSums sums(int samples) const {
    const int doubled = static_cast<int>(std::bit_floor(static_cast<unsigned>(samples)));
    const int before = doubled / 2;
    const double change = variance(before) - variance(samples);
    ChangeSums sums;
    sums.squares = pixels_ * change;
    sums.fourths = pixels_ * 3 * change * change;
    sums.squares_before = pixels_ * (samples == doubled ? variance(0.5 * before) - variance(before)
                                                        : variance(before) - variance(doubled));
    sums.luminance = pixels_;
    sums.pixels = pixels_;
    return sums;
  }

  Noise after(int samples, Sampler sampler = Sampler::sobol) const {
    Noise noise(sampler);
    for (int n = 2 * Noise::kFirst; n <= samples; n *= 2) noise.doubled(sums(n), n);
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
    for (const int samples : {256, 300, 500}) {
      CAPTURE(samples);
      const NoiseEstimate estimate = noise.estimate(changes.sums(samples), samples);
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
    const NoiseEstimate estimate = changes.after(samples).estimate(changes.sums(samples), samples);
    CHECK(std::abs(estimate.exponent() - 1.5) < error);
    CHECK(estimate.upper / estimate.relative < margin);
    error = std::abs(estimate.exponent() - 1.5);
    margin = estimate.upper / estimate.relative;
  }
  CHECK(error < 0.1);
}

TEST_CASE("independent samples are known to be so from the start") {
  const Changes changes(0);
  for (const int samples : {12, 16, 24}) {
    CAPTURE(samples);
    const auto estimate = [&](Sampler sampler) {
      return changes.after(samples, sampler).estimate(changes.sums(samples), samples);
    };
    const double truth = std::sqrt(changes.variance(samples));
    CHECK(estimate(Sampler::random).relative == Approx(truth).epsilon(0.01));
    CHECK(estimate(Sampler::random).exponent() < 1.01);
    CHECK(estimate(Sampler::sobol).relative < 0.97 * truth);
  }
}

TEST_CASE("a change that is small by chance does not pass for noise that falls fast") {
  const Changes changes(0);
  const auto estimateAt = [&](int samples, double chance) {
    Noise noise;
    for (int n = 16; n <= samples; n *= 2) {
      ChangeSums sums = changes.sums(n);
      if (n == samples) sums.squares *= chance;
      noise.doubled(sums, n);
      if (n == samples) return noise.estimate(sums, n);
    }
    return NoiseEstimate{};
  };
  const NoiseEstimate as_expected = estimateAt(128, 1);
  const NoiseEstimate by_chance = estimateAt(128, 0.9);
  // By this change alone the noise would be 5% smaller, with the fall that it pretends 13%.
  CHECK(by_chance.relative > 0.95 * as_expected.relative);
  CHECK(by_chance.exponent() < as_expected.exponent() + 0.05);
}

TEST_CASE("fewer pixels are less certain") {
  const Changes many(3, 1e6);
  const Changes few(3, 100);
  const auto margin = [](const Changes& changes) {
    const NoiseEstimate estimate = changes.after(64).estimate(changes.sums(64), 64);
    return estimate.upper / estimate.relative;
  };
  CHECK(margin(few) > 1.05 * margin(many));
}

TEST_CASE("the samples that a goal takes are those at which the noise is below it") {
  const Changes changes(0);
  const NoiseEstimate now = changes.after(512).estimate(changes.sums(512), 512);
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
  const NoiseEstimate estimate = noise.estimate(sums, 16);
  CHECK(estimate.relative == 0);
  CHECK(estimate.upper == 0);
}
