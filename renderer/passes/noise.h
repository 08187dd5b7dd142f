// The noise of a picture, from how it changes as samples are added.
#pragma once

#include "renderer/core/noise_estimate.h"
#include "renderer/core/sampler.h"
#include "renderer/passes/change_trend.h"

namespace glimt {

// Sums over a picture: of the squared relative change of its pixels' luminance, of the squares of
// these, of the squared change at the doubling before, and of the luminance. What a change is
// relative to is in shaders/change.glsl. Pixels that get no more samples do not change: of them it
// holds the noise that they have, squared.
struct ChangeSums {
  double squares = 0;
  double fourths = 0;
  double squares_before = 0;
  double luminance = 0;
  double resting = 0;
  double pixels = 0;
};

// The variance of scrambled low-discrepancy points is not that of independent ones: it falls
// faster, and the spread of the samples says nothing of it. What is used here holds for both. A
// sequence of 2n points is two of n that are scrambled alike, so of the means A, B over the halves
// and M over the whole
//   E (A - M)^2 = V(n) - V(2n),
// since the mean square of A's and B's errors is that of M's and that of their distance from M.
// What is left at 2n is the sum of all later changes, so it is known once it is known how they go
// on:
//   V(n) = a / n + b / n^1.5,
// the first part being what is as random as with independent samples, the second what is smooth but
// for edges (Mitchell 1996, "Consequences of stratified sampling in graphics"). How the changes
// fall from doubling to doubling gives a : b, see ChangeTrend. With b = 0 the change at one is the
// variance of the mean of two halves.
class Noise {
 public:
  // The first doubling whose change is known: from 4 to 8 samples.
  static constexpr int kFirst = 8;

  explicit Noise(Sampler sampler = Sampler::sobol);

  // At `samples`, a power of two and at least 16, the change since half as many, and before that
  // since a quarter as many. To be called for each such number of samples in turn.
  void doubled(const ChangeSums& sums, int samples);

  // At `samples`, from the last doubling to the next, with the change since half of the samples at
  // that doubling. Between them, the one before is that of the doubling.
  NoiseEstimate estimate(const ChangeSums& sums, int samples) const;

 private:
  int doubled_ = kFirst;     // samples at the last doubling
  ChangeTrend first_trend_;  // without having seen a change
  ChangeTrend trend_;        // before the change of the last doubling is seen
};

}  // namespace glimt
