// Some drivers compute mediump in 16 bits. shaders/prelude.glsl guards against it in several
// places; each guard is tried, and the same without it to see whether it is needed.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "renderer/gl/device.h"

namespace glimt {

struct GuardProbe {
  std::string guard;
  std::size_t texels = 0;         // looked at
  std::size_t wrong = 0;          // of them, with the guard
  std::size_t wrong_without = 0;  // of them
};

inline constexpr const char* kGuardOfSum =
    "uZero";  // the one that not every driver with 16 bits needs

std::vector<GuardProbe> probeGuards(const gl::Device& device);

}  // namespace glimt
