#include "app/viewer/preview_scale.h"

#include <algorithm>
#include <cmath>

namespace glimt {
namespace {

// Seconds of a sample: what is aimed at, and what is left as it is.
constexpr double kGoal = 0.025;
constexpr double kShortest = 0.008;
constexpr double kLongest = 0.035;

constexpr int kLargestDivisor = 16;

}  // namespace

void PreviewScale::learn(double pixels, double seconds) {
  // Drivers compile while they draw for the first time.
  const bool was_warm = warm_;
  warm_ = true;
  if (!was_warm) return;
  const double last = seconds / pixels;
  seconds_per_pixel_ = 0.5 * (seconds_per_pixel_.value_or(last) + last);
}

int PreviewScale::divisorFor(double pixels) {
  if (!seconds_per_pixel_) return divisor_;
  const double full = pixels * *seconds_per_pixel_;
  const double expected = full / (divisor_ * divisor_);
  const bool fits = expected <= kLongest && (expected >= kShortest || divisor_ == 1);
  if (!fits) {
    divisor_ = static_cast<int>(
        std::clamp(std::ceil(std::sqrt(full / kGoal)), 1.0, static_cast<double>(kLargestDivisor)));
  }
  return divisor_;
}

}  // namespace glimt
