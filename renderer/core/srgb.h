// How displays encode light: IEC 61966-2-1.
#pragma once

#include <cmath>
#include <cstdint>

namespace glimt {

// From 0 to 1, linear.
inline double linearOfSrgb(std::uint8_t encoded) {
  const double s = encoded / 255.0;
  return s <= 0.04045 ? s / 12.92 : std::pow((s + 0.055) / 1.055, 2.4);
}

}  // namespace glimt
