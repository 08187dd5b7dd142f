#pragma once

#include <cmath>

#include "renderer/core/vector.h"

namespace glimt {

// Pinhole camera. World space, metres, right-handed; square pixels.
struct Camera {
  Vec3 position{0, 0, 1};
  Vec3 target{0, 0, 0};
  Vec3 up{0, 1, 0};
  float vertical_fov = 40;  // degrees over the picture's height, in (0, 180)
};

// Unit vectors of a camera, and half the height of its picture at distance one.
struct CameraFrame {
  Vec3 forward;
  Vec3 right;
  Vec3 up;
  float half_height;

  explicit CameraFrame(const Camera& camera)
      : forward(glm::normalize(camera.target - camera.position)),
        right(glm::normalize(glm::cross(forward, camera.up))),
        up(glm::cross(right, forward)),
        half_height(std::tan(glm::radians(camera.vertical_fov) / 2)) {}
};

}  // namespace glimt
