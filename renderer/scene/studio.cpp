#include "renderer/scene/studio.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "renderer/core/vector.h"

namespace glimt {
namespace {

constexpr int kWidth = 512;
constexpr int kHeight = 256;

// A rectangle of light that faces the middle of the room.
struct SoftBox {
  float azimuth;     // degrees from the front, +z, to the right, +x
  float elevation;   // degrees
  float half_width;  // tangents of the angles at which its edges are seen
  float half_height;
  Vec3 radiance;

  // 1 within, 0 outside, and between them an edge without a step.
  float at(const Vec3& direction) const {
    constexpr float kEdge = 0.12f;
    const float a = glm::radians(azimuth);
    const float e = glm::radians(elevation);
    const Vec3 to(std::cos(e) * std::sin(a), std::sin(e), std::cos(e) * std::cos(a));
    const Vec3 side(std::cos(a), 0, -std::sin(a));
    const float depth = glm::dot(direction, to);
    if (depth <= 0) return 0;
    const float x = std::abs(glm::dot(direction, side)) / depth;
    const float y = std::abs(glm::dot(direction, glm::cross(to, side))) / depth;
    return glm::smoothstep(half_width + kEdge, half_width - kEdge, x) *
           glm::smoothstep(half_height + kEdge, half_height - kEdge, y);
  }
};

const SoftBox kBoxes[]{
    {42, 38, 0.55f, 0.55f, Vec3(3.7f, 3.5f, 3.3f)},    // key
    {-60, 12, 0.38f, 0.75f, Vec3(1.25f, 1.3f, 1.4f)},  // fill
    {0, 88, 0.80f, 0.55f, Vec3(1.25f)},                // overhead
    {118, 15, 0.18f, 0.80f, Vec3(2.5f)},               // edges
    {-118, 15, 0.18f, 0.80f, Vec3(2)},
};

// A wall a little lighter above than below, and a floor with light on it.
Vec3 room(const Vec3& direction) {
  return Vec3(0.045f + 0.03f * glm::smoothstep(-0.4f, 0.6f, direction.y) +
              0.06f * glm::smoothstep(-0.2f, -0.9f, direction.y));
}

Vec3 radianceFrom(const Vec3& direction) {
  Vec3 radiance = room(direction);
  for (const SoftBox& box : kBoxes) radiance = glm::mix(radiance, box.radiance, box.at(direction));
  return radiance;
}

}  // namespace

Image makeStudio() {
  constexpr float kPi = std::numbers::pi_v<float>;
  Image image{kWidth, kHeight, {}};
  image.pixels.reserve(static_cast<std::size_t>(kWidth) * kHeight);
  for (int y = 0; y < kHeight; ++y)
    for (int x = 0; x < kWidth; ++x) {
      const float around = 2 * kPi * ((static_cast<float>(x) + 0.5f) / kWidth - 0.5f);
      const float down = kPi * (static_cast<float>(y) + 0.5f) / kHeight;
      image.pixels.push_back(radianceFrom(
          {std::sin(down) * std::cos(around), std::cos(down), std::sin(down) * std::sin(around)}));
    }
  return image;
}

}  // namespace glimt
