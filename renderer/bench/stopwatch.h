// Seconds that the device works, and their spread.
#pragma once

#include <algorithm>
#include <chrono>
#include <vector>

#include "renderer/bench.h"
#include "renderer/gl/device.h"

namespace glimt {

// From the call to the end of all that it has the device do.
template <class Work>
double secondsOf(const gl::Device& device, const Work& work) {
  device.gl().Finish();
  const auto start = std::chrono::steady_clock::now();
  work();
  device.gl().Finish();
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

inline Spread spreadOf(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  return {values[values.size() / 2], values.front(), values.back()};
}

}  // namespace glimt
