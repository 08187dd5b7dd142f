#include "renderer/passes/noise.h"

#include <algorithm>
#include <cmath>

namespace glimt {
namespace {

// One-sided, at 95%.
constexpr double kDeviations = 1.645;

// Standard deviation of a measured exponent beside the one that follows from the pixels' number,
// and how much the true one moves from one doubling to the next; docs/accuracy.md has how well the
// claims that follow hold.
constexpr double kExponentDeviation = 0.1;
constexpr double kExponentDrift = 0.05;

// Of the noise, relative, beside those.
constexpr double kModelDeviation = 0.05;

// Relative standard deviation of a sum of squares of normally distributed changes: the variance of
// such a square is two thirds of the mean of its own square.
double deviationOf(const ChangeSums& sums) {
  return std::sqrt(2.0 / 3 * sums.fourths) / sums.squares;
}

// a / n + b / n^1.5, for n in units of the samples at the last doubling.
class Variance {
 public:
  // The change at that doubling is 1, and that of the next 2^-exponent.
  explicit Variance(double exponent) {
    const double fast = std::exp2(-1.5);
    const double share = std::clamp((0.5 - std::exp2(-exponent)) / (0.5 - fast), 0.0, 1.0);
    a_ = 1 - share;
    b_ = share / (1 / fast - 1);
  }

  // Share of the variance that falls as 1 / n.
  double slowShare(double n) const { return a_ / n / at(n); }
  double at(double n) const { return a_ / n + b_ / (n * std::sqrt(n)); }

  // What is left after a change.
  double perChange(double n, double before) const { return at(n) / (at(before) - at(n)); }

 private:
  double a_;
  double b_;
};

}  // namespace

// A Kalman filter of one number.
void Noise::doubled(const ChangeSums& sums, int samples) {
  doubled_ = samples;
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
  NoiseEstimate noise;
  noise.samples = samples;
  const double n = static_cast<double>(samples) / doubled_;
  const double n_before = static_cast<double>(before) / doubled_;
  const Variance variance(exponent_);
  noise.slow = variance.slowShare(n);
  const double active = sums.squares * variance.perChange(n, n_before);
  const double total = active + sums.resting;
  if (!(total > 0)) return noise;
  noise.relative = std::sqrt(total / sums.pixels);
  noise.resting = sums.resting / total;
  // Half of the variance's relative deviations; the picture's own error deviates as much from its
  // mean as the estimate.
  const double of_pixels = sums.squares > 0 ? deviationOf(sums) / std::sqrt(2.0) : 0;
  const double step = std::sqrt(variance_);
  const double of_exponent = 0.25 * std::log(Variance(exponent_ - step).perChange(n, n_before) /
                                             Variance(exponent_ + step).perChange(n, n_before));
  const double deviation = std::sqrt(of_pixels * of_pixels + of_exponent * of_exponent +
                                     kModelDeviation * kModelDeviation);
  noise.lower = noise.relative * std::max(1 - kDeviations * deviation, 0.0);
  noise.upper = noise.relative * (1 + kDeviations * deviation);
  return noise;
}

double Noise::perChange(int samples, int before) const {
  return Variance(exponent_).perChange(static_cast<double>(samples) / doubled_,
                                       static_cast<double>(before) / doubled_);
}

double Noise::power(int samples) const {
  const double slow = Variance(exponent_).slowShare(static_cast<double>(samples) / doubled_);
  return slow + 1.5 * (1 - slow);
}

}  // namespace glimt
