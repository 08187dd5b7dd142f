// How far one picture is from another.
#pragma once

#include "renderer/core/image.h"

namespace glimt {

// Errors: input, naming both sizes, when they are not the same.
void demandSameSize(int width, int height, int reference_width, int reference_height);

struct ImageDifference {
  Vec3 mean_ratio{1};       // mean(image) / mean(reference), per channel
  double mse = 0;           // mean squared difference over pixels and channels
  double relative_mse = 0;  // mean of (I - R)^2 / (R^2 + 0.01) over pixels and channels
  double psnr = 0;          // decibels, against the reference's largest value; infinite when equal
  double largest = 0;       // largest absolute difference of one channel
  double noise = 0;  // as NoiseEstimate defines it, the reference being the converged picture
};

// Both pictures have the same size. Errors: input, naming both sizes, when they have not; and when
// a value is not finite.
ImageDifference differenceOf(const Image& image, const Image& reference);

}  // namespace glimt
