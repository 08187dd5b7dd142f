// The noise of a picture, from how it changes as samples are added.
#pragma once

#include <optional>

#include "renderer/core/noise_estimate.h"

namespace glimt {

// Sums over a picture: of the squared relative change of its pixels' luminance between two numbers
// of samples, of the squares of these, of the same between two numbers of samples before, and of
// the luminance. What a change is relative to is in shaders/change.glsl.
struct ChangeSums {
  double squares = 0;
  double fourths = 0;
  double squares_before = 0;
  double luminance = 0;
  double pixels = 0;
};

// The variance of scrambled low-discrepancy points is not that of independent ones: it falls
// faster, and the spread of the samples says nothing of it. What is used here holds for both. A
// sequence of 2n points is two of n that are scrambled alike, so of the means A, B over the halves
// and M over the whole
//   E (A - M)^2 = V(n) - V(2n),
// since the mean square of A's and B's errors is that of M's and that of their distance from M.
// With V falling as n^-e, the picture's changes at two doublings give e, and one change gives V:
//   V(N) = E (M_N - M_n)^2 / ((N / n)^e - 1).
// With e = 1, that of independent samples, and N = 2n it is the variance of the mean of two halves.
class Noise {
 public:
  // The first doubling whose change is known: from 4 to 8 samples.
  static constexpr int kFirst = 8;

  // At `samples`, a power of two and at least 16, the change since half as many, and before that
  // since a quarter as many. To be called for each such number of samples in turn.
  void doubled(const ChangeSums& sums);

  // At `samples`, with the change since `before` samples. Nothing where the picture is black.
  NoiseEstimate estimate(const ChangeSums& sums, int samples, int before) const;

 private:
  // Known beforehand: paths of a few bounces are between independent samples, 1, and smooth
  // integrands of few dimensions, 1.5 and more.
  double exponent_ = 1.1;
  double variance_ = 0.15 * 0.15;  // of the exponent
};

}  // namespace glimt
