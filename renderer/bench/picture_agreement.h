// Whether two pictures made with the same sample points show the same scene.
#pragma once

#include <cstddef>
#include <vector>

#include "renderer/core/vector.h"

namespace glimt {

struct PictureAgreement {
  bool agrees = false;
  std::size_t lost = 0;  // pixels that lack a sample in either picture, and were not compared
};

// Compares the mean radiance of each channel. The pictures hold means of `samples` samples, and
// their number in the fourth channel.
//
// With the same points a path differs between the two only by what a packed record rounds, mostly a
// little, and altogether where it just misses or hits an edge. The rounding is random with mean
// zero, so the mean over n pixels of what they differ by is itself a random number around zero, and
// its standard deviation is that of the differences divided by sqrt(n): it is read from the
// pictures themselves. Five of them are exceeded by chance once in a million. What is not random,
// directions rounded to 15 bits an axis and sums of floats, is forgiven with 0.05% of the mean.
PictureAgreement comparePictures(const std::vector<Vec4>& picture,
                                 const std::vector<Vec4>& reference, int samples);

}  // namespace glimt
