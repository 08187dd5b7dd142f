// Axis-aligned box.
#pragma once

#include <limits>

#include "renderer/core/vector.h"

namespace glimt {

struct Bounds {
  Vec3 min{std::numeric_limits<float>::infinity()};
  Vec3 max{-std::numeric_limits<float>::infinity()};

  bool empty() const { return min.x > max.x; }
  void include(const Vec3& point) {
    min = glm::min(min, point);
    max = glm::max(max, point);
  }
  void include(const Bounds& other) {
    min = glm::min(min, other.min);
    max = glm::max(max, other.max);
  }
  Vec3 size() const { return max - min; }
  Vec3 center() const { return 0.5f * min + 0.5f * max; }
  // Half the surface area: proportional to the chance that a random line meets the box.
  float halfArea() const {
    if (empty()) return 0.0f;
    const Vec3 s = size();
    return s.x * s.y + s.y * s.z + s.z * s.x;
  }
};

}  // namespace glimt
