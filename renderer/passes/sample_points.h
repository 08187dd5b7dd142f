// Low-discrepancy points for the passes, computed on the CPU.
#pragma once

#include <cstdint>
#include <string>

#include "renderer/core/sampler.h"
#include "renderer/core/vector.h"
#include "renderer/gl/device.h"
#include "renderer/gl/program.h"

namespace glimt {

// The sets of dimensions of a path's rays, the camera's being ray 0, and of the light samples where
// they end.
constexpr std::uint32_t raySet(int ray) {
  return 2 * static_cast<std::uint32_t>(ray);
}
constexpr std::uint32_t lightSet(int ray) {
  return raySet(ray) + 1;
}

// Where the camera's ray starts on its lens.
constexpr std::uint32_t kLensSet = 0xffffffffu;

// Every pass of every bounce takes one four-dimensional point per sample: a set of dimensions. The
// points of a set are Sobol's, shuffled and scrambled by nested uniform permutations, as in Burley
// 2020, "Practical Hash-based Owen Scrambling", JCGT 10(4). Or, with Sampler::random, they are
// independent.
class SamplePoints {
 public:
  explicit SamplePoints(std::uint32_t seed, Sampler sampler = Sampler::sobol)
      : seed_(seed), sampler_(sampler) {}

  Sampler sampler() const { return sampler_; }

  // In [0, 1)^4, each coordinate a multiple of 2^-23. `group` says which of POINT_GROUPS sequences
  // it is of, that are scrambled independently of each other.
  Vec4 point(std::uint32_t sample, std::uint32_t set, std::uint32_t group = 0) const;

  // Hands the points of all groups to a program's array of that name, which holds those of several
  // sets behind each other: as its `place`th.
  void bindPoints(gl::Program& program, const std::string& array, std::uint32_t sample,
                  std::uint32_t set, std::uint32_t place = 0) const;

  // In whole texels of the offsets: where this set begins, and how far repetitions are moved; see
  // shaders/sample_points.glsl.
  Vec4 offsetsShift(std::uint32_t set) const;

  // Random multiples of 2^-23 in [0, 1), four a texel.
  gl::Texture makeOffsets(const gl::Device& device) const;

 private:
  std::uint32_t seed_;
  Sampler sampler_;
};

}  // namespace glimt
