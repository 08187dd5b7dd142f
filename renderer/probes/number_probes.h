// Numbers that float textures have to keep.
#pragma once

#include <cstddef>
#include <vector>

#include "renderer/gl/device.h"

namespace glimt {

// Whole numbers of up to 24 bits times 2^-60 to 2^60, of both signs: the same in every run.
std::vector<Vec4> scaledIntegers(std::size_t count);

// How many texels of `is` are not those of `expected`, which is as long.
std::size_t countDifferent(const std::vector<Vec4>& is, const std::vector<Vec4>& expected);

struct NumbersProbe {
  std::size_t texels = 0;  // looked at
  std::size_t wrong = 0;   // of them
};

// Uploads numbers, samples them in a shader that writes them to a target, and reads them back: all
// whole numbers from -(2^24 - 1) to 2^24 - 1, and numbers of all sizes.
NumbersProbe probeAllIntegers(const gl::Device& device);
NumbersProbe probeScaledIntegers(const gl::Device& device);

}  // namespace glimt
