// Low-discrepancy points for the passes, computed on the CPU.
#pragma once

#include <cstdint>

#include "renderer/core/vector.h"
#include "renderer/gl/device.h"

namespace glimt {

// Every pass of every bounce takes one four-dimensional point per sample: a set of dimensions. The
// points of a set are Sobol's, shuffled and scrambled by nested uniform permutations: Burley 2020,
// "Practical Hash-based Owen Scrambling", JCGT 10(4).
class SamplePoints {
 public:
  explicit SamplePoints(std::uint32_t seed) : seed_(seed) {}

  // In [0, 1)^4, each coordinate a multiple of 2^-23.
  Vec4 point(std::uint32_t sample, std::uint32_t set) const;

  // In whole texels of the offsets: where this set begins, and how far repetitions are moved; see
  // shaders/sample_points.glsl.
  Vec4 offsetsShift(std::uint32_t set) const;

  // Random multiples of 2^-23 in [0, 1), four a texel.
  gl::Texture makeOffsets(const gl::Device& device) const;

 private:
  std::uint32_t seed_;
};

}  // namespace glimt
