// Whether two ways to cast rays found the same.
#pragma once

#include <cmath>
#include <cstddef>
#include <vector>

#include "renderer/bench/bench_rays.h"

namespace glimt {

// How many live rays have another result: hit instead of miss, or a distance that is off by more
// than rounding explains. Visibilities, which are 0 or 1, are compared with the same rule.
inline std::size_t countDifferent(const Rays& rays, const std::vector<float>& results,
                                  const std::vector<float>& reference) {
  constexpr float kTolerance = 1e-4f;  // of the distance
  std::size_t different = 0;
  for (std::size_t i = 0; i < rays.size(); ++i) {
    if (!rays.live(i)) continue;
    const bool close = std::abs(results[i] - reference[i]) <= kTolerance * std::abs(reference[i]);
    different += !close;
  }
  return different;
}

// A ray along an edge may be rounded to either side of it: one in ten thousand is forgiven.
inline bool agree(std::size_t different, std::size_t compared) {
  return different * 10000 <= compared;
}

}  // namespace glimt
