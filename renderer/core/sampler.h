// Where random numbers come from.
#pragma once

#include <array>
#include <string_view>

namespace glimt {

enum class Sampler {
  sobol,   // low-discrepancy points: the error falls faster than with independent ones
  random,  // independent ones, to see by how much
};

inline constexpr std::array<std::string_view, 2> kSamplerNames{"sobol", "random"};

}  // namespace glimt
