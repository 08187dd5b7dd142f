#include "renderer/passes/noise.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace glimt {
namespace {

// One-sided, at 95%.
constexpr double kDeviations = 1.645;

// Standard deviation of a change's logarithm to base 2, beside the one that follows from the
// pixels' number: pixels share sequences of points.
constexpr double kChangeDeviation = 0.12;

// Of the noise, relative, beside what is uncertain about the changes.
constexpr double kModelDeviation = 0.05;

// The estimate's margin is foretold for so many doublings on.
constexpr int kLater = 3;

double square(double x) {
  return x * x;
}

// Relative standard deviation of a sum of squares of normally distributed changes: the variance of
// such a square is two thirds of the mean of its own square.
double deviationOf(const ChangeSums& sums) {
  return std::sqrt(2.0 / 3 * sums.fourths) / sums.squares;
}

// Of the logarithm to base 2.
double varianceOf(const ChangeSums& sums) {
  return square(deviationOf(sums) / std::numbers::ln2) + square(kChangeDeviation);
}

// The power of the samples by which changes fall, known beforehand. Light that has met a few
// surfaces is hardly smooth.
ChangeTrend trendOf(Sampler sampler) {
  return sampler == Sampler::random ? ChangeTrend(1, 0.02) : ChangeTrend(1.18, 0.12);
}

// a / n + b / n^kSmoothPower, for n in units of the samples at the last doubling, whose change
// is 1. That of the next is 2^-power.
class Variance {
 public:
  explicit Variance(double power) {
    const double fast = std::exp2(-kSmoothPower);
    const double share = std::clamp((0.5 - std::exp2(-power)) / (0.5 - fast), 0.0, 1.0);
    a_ = 1 - share;
    b_ = share / (1 / fast - 1);
  }

  // Share of the variance that falls as 1 / n.
  double slowShare(double n) const { return a_ / n / at(n); }
  double at(double n) const { return a_ / n + b_ / std::pow(n, kSmoothPower); }

 private:
  double a_;
  double b_;
};

// The logarithm of what is left at n samples.
double left(double power, double n) {
  return std::log2(Variance(power).at(n));
}

// The logarithm of the change from half of the last doubling's samples to n.
double changed(double power, double n) {
  const Variance variance(power);
  return std::log2(variance.at(0.5) - variance.at(n));
}

double slopeOf(double (*function)(double power, double n), double power, double n) {
  constexpr double kStep = 0.01;
  return (function(power + kStep, n) - function(power - kStep, n)) / (2 * kStep);
}

// Relative, of the noise: what is uncertain about the estimate, as far as its square's logarithm is
// that of what is left, and about the picture's own error, which is off its mean as changes are.
double marginOf(const ChangeTrend& trend, const ChangeSums& sums, double n) {
  const double of_left = trend.variance(slopeOf(left, trend.power(), n));
  return kDeviations * std::sqrt(square(0.5 * std::numbers::ln2) * of_left +
                                 square(0.5 * deviationOf(sums)) + square(kModelDeviation));
}

// When as much has been seen as will be then.
double laterMargin(ChangeTrend trend, const ChangeSums& sums) {
  for (int i = 0; i < kLater; ++i) {
    trend.advance(trend.power());
    trend.see(0, 0, varianceOf(sums));
  }
  return marginOf(trend, sums, 1);
}

}  // namespace

Noise::Noise(Sampler sampler) : first_trend_(trendOf(sampler)), trend_(first_trend_) {}

// Changes are relative to what is known of the pixels now, so that of the doubling before is
// measured anew: as the unit.
void Noise::doubled(const ChangeSums& sums, int samples) {
  doubled_ = samples;
  if (!(sums.squares > 0) || !(sums.squares_before > 0)) {
    trend_ = first_trend_;
    return;
  }
  trend_.see(-trend_.level(), 0, varianceOf(sums));
  trend_.advance(std::log2(sums.squares_before / sums.squares));
}

NoiseEstimate Noise::estimate(const ChangeSums& sums, int samples) const {
  NoiseEstimate noise;
  noise.samples = samples;
  ChangeTrend trend = trend_;
  const double n = static_cast<double>(samples) / doubled_;
  double active = 0;
  double margin = kDeviations * kModelDeviation;
  noise.later = 1 + margin;
  if (sums.squares > 0) {
    // The change is that of the last doubling, or goes beyond it.
    const double expected = changed(trend.power(), n);
    const double unit = samples > doubled_ && sums.squares_before > 0
                            ? sums.squares_before
                            : sums.squares / std::exp2(expected);
    trend.see(std::log2(sums.squares / unit) - expected - trend.level(),
              slopeOf(changed, trend.power(), n), varianceOf(sums));
    active = unit * std::exp2(trend.level() + left(trend.power(), n));
    margin = marginOf(trend, sums, n);
    noise.later = 1 + laterMargin(trend, sums);
  }
  noise.slow = Variance(trend.power()).slowShare(n);
  const double total = active + sums.resting;
  if (!(total > 0)) return noise;
  noise.relative = std::sqrt(total / sums.pixels);
  noise.resting = sums.resting / total;
  noise.lower = noise.relative * std::max(1 - margin, 0.0);
  noise.upper = noise.relative * (1 + margin);
  return noise;
}

}  // namespace glimt
