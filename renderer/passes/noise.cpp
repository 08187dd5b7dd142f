#include "renderer/passes/noise.h"

#include <algorithm>
#include <cmath>

namespace glimt {
namespace {

// One-sided, at 95%.
constexpr double kDeviations = 1.645;

// Standard deviation of a measured exponent beside the one that follows from the pixels' number:
// the variance does not fall quite as a power, and the larger errors do it later.
constexpr double kExponentDeviation = 0.1;
constexpr double kExponentDrift = 0.05;  // from one doubling to the next

// Of the noise that is measured between two doublings.
constexpr double kModelDeviation = 0.03;

// Relative standard deviation of a sum of squares of normally distributed changes: the variance of
// such a square is two thirds of the mean of its own square.
double deviationOf(const ChangeSums& sums) {
  return std::sqrt(2.0 / 3 * sums.fourths) / sums.squares;
}

}  // namespace

// A Kalman filter of one number.
void Noise::doubled(const ChangeSums& sums) {
  if (!(sums.squares > 0) || !(sums.squares_before > 0)) return;
  const double measured = std::log2(sums.squares_before / sums.squares);
  const double of_pixels = deviationOf(sums) / std::log(2.0);
  const double variance = 2 * of_pixels * of_pixels + kExponentDeviation * kExponentDeviation;
  variance_ += kExponentDrift * kExponentDrift;
  const double gain = variance_ / (variance_ + variance);
  exponent_ += gain * (measured - exponent_);
  variance_ *= 1 - gain;
}

NoiseEstimate Noise::estimate(const ChangeSums& sums, int samples, int before) const {
  NoiseEstimate noise{samples, 0, 0, 0, exponent_, std::sqrt(variance_)};
  if (!(sums.squares > 0)) return noise;
  const double ratio = static_cast<double>(samples) / before;
  const double power = std::pow(ratio, exponent_);
  noise.relative = std::sqrt(sums.squares / sums.pixels / (power - 1));
  // Half of the variance's relative deviations; the picture's own error deviates as much from its
  // mean as the estimate.
  const double of_pixels = deviationOf(sums) / std::sqrt(2.0);
  const double of_exponent = 0.5 * std::log(ratio) * power / (power - 1) * noise.deviation;
  const double deviation = std::sqrt(of_pixels * of_pixels + of_exponent * of_exponent +
                                     kModelDeviation * kModelDeviation);
  noise.lower = noise.relative * std::max(1 - kDeviations * deviation, 0.0);
  noise.upper = noise.relative * (1 + kDeviations * deviation);
  return noise;
}

}  // namespace glimt
