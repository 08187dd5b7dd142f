#include "assets/generate/motorcycle/tyre.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "assets/generate/geometry/grid.h"

namespace glimt::assets::motorcycle {
namespace {

constexpr double kPi = std::numbers::pi;
constexpr double kGrooveDepth = 0.0045;

// 1 within a groove's half width of its middle, 0 outside, with sloping walls.
double groove(double distance, double half_width) {
  return 1 - glm::smoothstep(half_width - 0.0008, half_width + 0.0014, std::abs(distance));
}

// How deep the tread is cut: `around` and `across` are metres on its surface.
double treadDepth(double around, double across, double half_width, double pitch) {
  const double from_middle = std::abs(across);
  // Two grooves that run round, waving, and slanting ones that end at the shoulder.
  const double wave = 0.0025 * std::sin(2 * kPi * around / pitch);
  double cut = groove(across - 0.011 - wave, 0.0020);
  cut = std::max(cut, groove(across + 0.011 - wave, 0.0020));
  const double side_shift = across > 0 ? 0 : 0.5 * pitch;
  const double along = around + side_shift + 0.7 * from_middle;
  const double to_slant = (along / pitch - std::round(along / pitch)) * pitch;
  const double reach = glm::smoothstep(0.016, 0.019, from_middle) *
                       (1 - glm::smoothstep(0.86 * half_width, 0.93 * half_width, from_middle));
  cut = std::max(cut, groove(to_slant, 0.0021) * reach);
  const double half = (along / pitch + 0.5 - std::round(along / pitch + 0.5)) * pitch;
  const double short_reach =
      glm::smoothstep(0.024, 0.027, from_middle) *
      (1 - glm::smoothstep(0.7 * half_width, 0.76 * half_width, from_middle));
  return kGrooveDepth * std::max(cut, groove(half, 0.0015) * short_reach);
}

}  // namespace

Mesh tyre(double radius, double bead, double width, int steps_around) {
  constexpr int kAcross = 46;
  constexpr double kTreadHalf = 62;  // degrees of the crown that carry tread, to each side
  const double height = radius - bead;
  const double half = 0.5 * width;
  const int blocks = static_cast<int>(std::round(2 * kPi * radius / 0.034));
  const double pitch = 2 * kPi * radius / blocks;
  const double tread_arc = half * glm::radians(kTreadHalf);
  return grid(steps_around, kAcross, Edges::closed, Edges::open, [&](int i, int j) {
    const double angle = 2 * kPi * i / steps_around;
    // Nearly a circle that ends in two beads; denser over the crown.
    const double s = 2.0 * j / kAcross - 1;
    const double turn = glm::radians(s * (118 + 22 * std::abs(s * s * s)));
    const double c = std::cos(turn), side = std::sin(turn);
    const double middle = radius - 0.62 * height;
    double r = c > 0 ? middle + 0.62 * height * c : middle + 0.58 * height * c;
    double y = half * side * (c > 0 ? 1 : 1 + 0.12 * c);
    const double across = half * turn;
    const double depth =
        std::abs(across) < tread_arc ? treadDepth(radius * angle, across, tread_arc, pitch) : 0;
    r -= depth * c;
    y -= depth * side;
    return dvec3(r * std::cos(angle), y, -r * std::sin(angle));
  });
}

}  // namespace glimt::assets::motorcycle
