#include "renderer/core/noise_estimate.h"

#include <algorithm>
#include <cmath>

namespace glimt {

double NoiseEstimate::samplesFor(double goal) const {
  // In the beginning `upper` is farther from `relative`: it is hardly known how the noise falls.
  const double then = std::min(upper, 1.13 * relative);
  return samples * std::pow(then / goal, 2 / exponent());
}

}  // namespace glimt
