// What light a picture does without.
#pragma once

#include <optional>

namespace glimt {

// More are not asked for.
inline constexpr int kMostBounces = 64;

struct LightLimits {
  int bounces = 4;  // secondary bounces: a path has at most bounces + 1 scattering surfaces
  // The luminance of a pixel's sample above which it is dimmed, positive; none: never.
  std::optional<float> clamp = std::nullopt;
};

}  // namespace glimt
