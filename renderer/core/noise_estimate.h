// How wrong a picture still is by chance.
#pragma once

#include <algorithm>
#include <cmath>

namespace glimt {

// Noise is the root of the mean over the pixels of
//   (L - R)^2 / (R^2 + F^2),
// L being the luminance of the picture and R that of the picture with infinitely many samples, both
// linear; F is a quarter of R's mean, so that in the dark errors count as they are seen.
struct NoiseEstimate {
  int samples = 0;       // of the picture it is of
  double relative = 0;   // the likeliest
  double lower = 0;      // the noise is above this in 95% of the cases,
  double upper = 0;      // and below this in 95%
  double exponent = 1;   // its square falls with the samples to the power of minus this
  double deviation = 0;  // standard deviation of the exponent

  // How many samples bring `upper` down to a goal. By then it is nearer to `relative` than in the
  // beginning, when the exponent is hardly known.
  double samplesFor(double goal) const {
    const double then = std::min(upper, 1.1 * relative);
    return samples * std::pow(then / goal, 2 / exponent);
  }
};

}  // namespace glimt
