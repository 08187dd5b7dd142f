#include "renderer/core/noise_estimate.h"

#include <algorithm>
#include <cmath>

namespace glimt {

double NoiseEstimate::samplesFor(double goal) const {
  // In the beginning `upper` is farther from `relative`: it is hardly known how the noise falls.
  const double then = std::min(upper, 1.1 * relative);
  const double wanted = goal * goal / (then * then);
  // The noise's square with samples / x^2 samples, as a share of what it is: rises with x.
  const auto share = [&](double x) { return (slow + (1 - slow) * x) * x * x; };
  double low = 0;
  double high = 1;
  while (share(high) < wanted) high *= 2;
  for (int i = 0; i < 60; ++i) {
    const double middle = 0.5 * (low + high);
    (share(middle) < wanted ? low : high) = middle;
  }
  return samples / (high * high);
}

}  // namespace glimt
