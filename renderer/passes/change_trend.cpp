#include "renderer/passes/change_trend.h"

#include "renderer/core/noise_estimate.h"

namespace glimt {
namespace {

// Of a level of which nothing is known.
constexpr double kUnknown = 1e4;

// Where a part falls as 1 / n and the rest as 1 / n^s, s being kSmoothPower, the power goes from s
// to 1, at the rate
//   d power / d ln n = -(power - 1) (s - power).
// Pictures are seen to do so by a good half of that: of ln 2 for a doubling, and with a drift
// beside it. How well the claims that follow hold is in docs/accuracy.md.
constexpr double kRate = 0.4;
constexpr double kDrift = 0.01;

}  // namespace

ChangeTrend::ChangeTrend(double power, double deviation)
    : power_(power), level_variance_(kUnknown), power_variance_(deviation * deviation) {}

double ChangeTrend::variance(double by_power) const {
  return level_variance_ + 2 * by_power * covariance_ + by_power * by_power * power_variance_;
}

void ChangeTrend::see(double off, double by_power, double variance) {
  const double with_level = level_variance_ + by_power * covariance_;
  const double with_power = covariance_ + by_power * power_variance_;
  const double seen = with_level + by_power * with_power + variance;
  level_ += with_level / seen * off;
  power_ += with_power / seen * off;
  level_variance_ -= with_level / seen * with_level;
  covariance_ -= with_level / seen * with_power;
  power_variance_ -= with_power / seen * with_power;
}

void ChangeTrend::advance(double fall) {
  level_ += fall - power_;
  level_variance_ += power_variance_ - 2 * covariance_;
  covariance_ -= power_variance_;
  double stays = 1;  // of what the power is off
  const double to_slow = power_ - 1;
  const double to_smooth = kSmoothPower - power_;
  if (to_smooth > 0) {
    stays -= kRate * (to_smooth - to_slow);
    power_ -= kRate * to_slow * to_smooth;
  }
  covariance_ *= stays;
  power_variance_ = stays * stays * power_variance_ + kDrift * kDrift;
}

}  // namespace glimt
