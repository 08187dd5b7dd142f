// How wrong a picture still is by chance.
#pragma once

namespace glimt {

// F of the noise, as a share of the picture's mean luminance: see NoiseEstimate.
inline constexpr double kNoiseFloor = 0.25;

// The power of the samples by which the smooth part of the noise's square falls; the rest falls
// with their power of 1.
inline constexpr double kSmoothPower = 1.5;

// Noise is the root of the mean over the pixels of
//   (L - R)^2 / (R^2 + F^2),
// L being the luminance of the picture and R that of the picture with infinitely many samples, both
// linear; F is a quarter of R's mean, so that in the dark errors count as they are seen.
struct NoiseEstimate {
  int samples = 0;      // of the picture it is of
  double relative = 0;  // the likeliest
  double lower = 0;     // the noise is above this in 95% of the cases,
  double upper = 0;     // and below this in 95%
  double later = 1;     // upper / relative, as it will be when a few times as many samples are seen
  double resting = 0;   // share of its square that stays: of pixels that get no more samples
  double slow = 1;      // share of its square that falls as 1 / samples; the rest is smooth

  // The power of the samples by which the noise's square falls at present, positive.
  double exponent() const { return slow + kSmoothPower * (1 - slow); }

  // How many samples bring `upper` down to a goal above 0; infinitely many where the pixels that
  // get no more have too much of it.
  double samplesFor(double goal) const;
};

}  // namespace glimt
