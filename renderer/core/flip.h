// How different two pictures look to people who switch between them.
#pragma once

#include <vector>

#include "renderer/core/image.h"

namespace glimt {

struct FlipDifference {
  double mean = 0;            // over the picture, from 0 to 1
  std::vector<float> pixels;  // of each, rows from the top
};

// FLIP of Andersson et al. 2020, "FLIP: A Difference Evaluator for Alternating Images", HPG, for
// pictures on a display with its pixels at 67 to a degree of the eye's view: 0.7 m away, 0.7 m
// wide, 3840 of them across. Errors: input, when the pictures' sizes are not the same.
FlipDifference flipOf(const DisplayImage& image, const DisplayImage& reference);

// The difference as a picture, from black over purple and orange to pale yellow.
DisplayImage flipPicture(const FlipDifference& difference, int width, int height);

}  // namespace glimt
