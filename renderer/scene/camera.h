#pragma once

#include "renderer/core/vector.h"

namespace glimt {

// Pinhole camera. World space, metres, right-handed; square pixels.
struct Camera {
  Vec3 position{0, 0, 1};
  Vec3 target{0, 0, 0};
  Vec3 up{0, 1, 0};
  float vertical_fov = 40;  // degrees over the picture's height, in (0, 180)
};

}  // namespace glimt
