// Boxes of four lanes, the last one unused: each bound fills one vector register, and including a
// box takes two instructions.
#pragma once

#include <limits>

#include "renderer/core/bounds.h"

namespace glimt {

using Float4 [[gnu::vector_size(16)]] = float;

struct Box4 {
  static constexpr float kInfinity = std::numeric_limits<float>::infinity();

  Float4 min{kInfinity, kInfinity, kInfinity, kInfinity};
  Float4 max{-kInfinity, -kInfinity, -kInfinity, -kInfinity};

  Box4() = default;
  explicit Box4(const Bounds& box)
      : min{box.min.x, box.min.y, box.min.z, 0}, max{box.max.x, box.max.y, box.max.z, 0} {}

  void include(Float4 point) {
    min = point < min ? point : min;
    max = point > max ? point : max;
  }
  void include(const Box4& other) {
    min = other.min < min ? other.min : min;
    max = other.max > max ? other.max : max;
  }
  Float4 center() const { return 0.5f * min + 0.5f * max; }
  // Not for an empty box.
  float halfArea() const {
    const Float4 s = max - min;
    return s[0] * s[1] + s[1] * s[2] + s[2] * s[0];
  }
  Bounds bounds() const { return {Vec3(min[0], min[1], min[2]), Vec3(max[0], max[1], max[2])}; }
};

}  // namespace glimt
