#include <cmath>

#include "assets/generate/geometry/curve.h"
#include "assets/generate/geometry/solids.h"
#include "assets/generate/motorcycle/parts.h"

namespace glimt::assets::motorcycle {
namespace {

// A crescent of sheet metal, `width` wide and so much higher in its middle, with rolled edges.
std::vector<dvec2> guardSection(double width, double crown) {
  constexpr int kSteps = 20;
  constexpr double kThick = 0.0022, kRolled = 0.0032;
  std::vector<dvec2> section;
  for (int k = 0; k <= kSteps; ++k) {  // the upper side, from right to left
    const double s = 1 - 2.0 * k / kSteps;
    section.emplace_back(0.5 * width * s, crown * (1 - s * s));
  }
  for (const double a : {160.0, 210.0, 260.0, 310.0})
    section.emplace_back(-0.5 * width + kRolled * std::cos(glm::radians(a)),
                         -kRolled + kRolled * std::sin(glm::radians(a)));
  for (int k = 0; k <= kSteps; ++k) {
    const double s = 2.0 * k / kSteps - 1;
    section.emplace_back((0.5 * width - kThick) * s, crown * (1 - s * s) - kThick);
  }
  for (const double a : {230.0, 280.0, 330.0, 20.0})
    section.emplace_back(0.5 * width + kRolled * std::cos(glm::radians(a)),
                         -kRolled + kRolled * std::sin(glm::radians(a)));
  return section;
}

Mesh guard(const dvec3& axle, double radius, double from, double to, double width, double crown) {
  const Path arc = arcPath(axle, {radius, 0, 0}, {0, radius, 0}, from, to, 72);
  // `up` of a sweep is where the section's y goes at the path's start: away from the axle.
  const double a = glm::radians(from);
  return sweep(
      arc, guardSection(width, crown), {std::cos(a), std::sin(a), 0}, [](double) { return 1.0; },
      true);
}

dvec3 onGuard(const dvec3& axle, double radius, double degrees, double z) {
  return axle +
         radius * dvec3(std::cos(glm::radians(degrees)), std::sin(glm::radians(degrees)), 0) +
         dvec3(0, 0, z);
}

}  // namespace

void addMudguards(Model& model) {
  constexpr double kFront = kWheelRadius + 0.013, kRear = kWheelRadius + 0.022;
  model.add("front mudguard", "mudguard", guard(kFrontAxle, kFront, 48, 172, 0.126, 0.014), 45);
  model.add("rear mudguard", "mudguard", guard(kRearAxle, kRear, 62, 158, 0.160, 0.020), 45);
  Mesh stays;
  for (const double side : {1.0, -1.0}) {
    for (const double angle : {74.0, 150.0})
      append(stays, tube(smoothPath({onGuard(kFrontAxle, kFront - 0.006, angle, side * 0.058),
                                     onGuard(kFrontAxle, kFront - 0.05,
                                             glm::mix(angle, 115.5, 0.15), side * 0.078),
                                     onFork(0.06, 0, side * 0.078)},
                                    8),
                         0.0045, 12));
    append(stays, tube({onGuard(kFrontAxle, kFront - 0.002, 115.5, side * 0.05),
                        onFork(0.262, -0.01, side * 0.085)},
                       0.006, 12));
    append(stays,
           tube({onGuard(kRearAxle, kRear - 0.006, 140, side * 0.074), {-0.80, 0.76, side * 0.085}},
                0.005, 12));
  }
  model.add("mudguard stays", "chrome", stays);
}

}  // namespace glimt::assets::motorcycle
