#include "renderer/core/noise_estimate.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace glimt {

double NoiseEstimate::samplesFor(double goal) const {
  // In the beginning `upper` is farther from `relative`: it is hardly known how the noise falls.
  const double then = std::min(upper, later * relative);
  const double share = (goal * goal / (then * then) - resting) / (1 - resting);
  if (!(share > 0)) return std::numeric_limits<double>::infinity();
  return samples * std::pow(share, -1 / exponent());
}

}  // namespace glimt
