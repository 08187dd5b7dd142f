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
  // Above 0: a parallel projection, whose picture is so many metres high.
  float orthographic_height = 0;
  float aperture_radius = 0;  // of a thin lens, in metres; 0: all is sharp
  float focus_distance = 1;   // metres along the view, where a lens is sharp
  int aperture_blades = 0;    // corners of the lens, 3 or more; 0: it is round
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
