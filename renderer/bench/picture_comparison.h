// Whether two ways to draw a scene with the same sample points give the same mean radiance.
#pragma once

#include <cstddef>
#include <vector>

#include "renderer/core/vector.h"

namespace glimt {

// With the same points a path differs between the two only by what a packed record rounds: mostly a
// little, and altogether where it just misses or hits an edge. The rounding is random with mean
// zero, so what the pictures' means differ by is a random number around zero. Its variance follows
// from how much the differences in each pixel vary from sample to sample; a pixel that differs in
// every sample alike adds nothing to it, so that even a few of these are found. Five standard
// deviations are exceeded by chance once in a million times. What is not random, directions rounded
// to 15 bits an axis and sums of floats, is forgiven with 0.05% of the mean.
class PictureComparison {
 public:
  // The radiance of one sample of each pixel in both.
  void add(const std::vector<Vec4>& picture, const std::vector<Vec4>& reference);

  // In every channel. False while there are not two samples of any pixel.
  bool agrees() const;

  // Values that are not known or not finite in either; they are not compared.
  std::size_t lost() const { return lost_; }

 private:
  struct Pixel {
    int samples = 0;
    glm::dvec3 reference{0};
    glm::dvec3 difference{0};
    glm::dvec3 squares{0};  // of the differences
  };
  std::vector<Pixel> pixels_;
  std::size_t lost_ = 0;
};

}  // namespace glimt
