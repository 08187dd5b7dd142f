#include "renderer/core/display_transform.h"

#include <algorithm>
#include <cmath>

namespace glimt {
namespace {

// IEC 61966-2-1, from 0 to 1.
float encodeSrgb(float linear) {
  return linear <= 0.0031308f ? 12.92f * linear : 1.055f * std::pow(linear, 1 / 2.4f) - 0.055f;
}

}  // namespace

DisplayImage displayImage(const Image& radiance, float exposure) {
  const float scale = std::exp2(exposure);
  DisplayImage display{radiance.width, radiance.height, {}};
  display.bytes.reserve(3 * radiance.pixels.size());
  for (const Vec3& pixel : radiance.pixels)
    for (int channel = 0; channel < 3; ++channel) {
      // In this order, so that no light times an infinite scale is black.
      const float clipped = std::min(std::max(0.0f, pixel[channel] * scale), 1.0f);
      const float value = encodeSrgb(clipped);
      display.bytes.push_back(static_cast<std::uint8_t>(std::lround(255 * value)));
    }
  return display;
}

}  // namespace glimt
