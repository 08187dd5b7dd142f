#include "assets/generate/geometry/curve.h"
#include "assets/generate/geometry/solids.h"
#include "assets/generate/motorcycle/parts.h"

namespace glimt::assets::motorcycle {
namespace {

constexpr double kArm = 0.098;    // of the swing arm's legs from the middle
constexpr double kShock = 0.135;  // of the shock absorbers

void addShock(Model& model, const dvec3& bottom, const dvec3& top) {
  const dmat4 place = pointing(bottom, top - bottom);
  const double length = glm::length(top - bottom);
  model.add("shock body", "black metal",
            transformed(lathe({{0, 0.03},
                               {0.016, 0.03},
                               {0.022, 0.045},
                               {0.022, 0.05},
                               {0.030, 0.055},
                               {0.030, 0.062},
                               {0.017, 0.066},
                               {0.017, 0.17},
                               {0, 0.17}},
                              40),
                        place));
  model.add("shock rod", "chrome",
            transformed(cylinder(0.0075, 0.15, length - 0.02, 0.001, 20), place));
  model.add("shock spring", "spring",
            transformed(coilSpring(0.0275, 0.0042, length - 0.135, 10, 28),
                        place * moved({0, 0.066, 0})));
  model.add("shock top", "polished alloy",
            transformed(lathe({{0.010, length - 0.075},
                               {0.034, length - 0.072},
                               {0.035, length - 0.066},
                               {0.032, length - 0.055},
                               {0.026, length - 0.035},
                               {0.014, length - 0.026},
                               {0, length - 0.026}},
                              40),
                        place));
  for (const dvec3& end : {bottom, top}) {
    const Mesh eye = transformed(ring(0.008, 0.021, -0.014, 0.014, 0.003, 32),
                                 moved(end) * turned(90, {1, 0, 0}));
    model.add("shock eye", "polished alloy", eye);
    const double side = end.z > 0 ? 1 : -1;
    const Mesh nut = transformed(
        boltHead(0.021), moved(end + dvec3(0, 0, side * 0.013)) * turned(90 * side, {1, 0, 0}));
    model.add("shock nut", "chrome", nut);
    model.add("shock bolt", "steel",
              tube({end - dvec3(0, 0, side * 0.05), end + dvec3(0, 0, side * 0.016)}, 0.008, 16));
  }
}

}  // namespace

void addSuspension(Model& model) {
  Mesh arm;
  const dvec3 forward(0.02, 0, 0);
  for (const double side : {1.0, -1.0}) {
    const dvec3 z(0, 0, side * kArm);
    append(arm,
           tube({kPivot + z, glm::mix(kPivot, kRearAxle, 0.5) + z, kRearAxle + z - 2.5 * forward},
                0.019, 24));
    append(arm, transformed(roundedBox({0.075, 0.052, 0.014}, 0.006, 3), moved(kRearAxle + z)));
  }
  append(arm, tube({kPivot - dvec3(0, 0, 0.112), kPivot + dvec3(0, 0, 0.112)}, 0.024, 28));
  append(arm, tube({kPivot + dvec3(-0.10, -0.016, -kArm), kPivot + dvec3(-0.10, -0.016, kArm)},
                   0.014, 20));
  model.add("swing arm", "frame", arm);
  for (const double side : {1.0, -1.0}) {
    addShock(model, {-0.665, 0.365, side * kShock}, {-0.555, 0.735, side * kShock});
    model.add("rear axle nut", "chrome",
              transformed(boltHead(0.034), moved(kRearAxle + dvec3(0, 0, side * 0.105)) *
                                               turned(90 * side, {1, 0, 0})));
    model.add("pivot nut", "chrome",
              transformed(boltHead(0.032), moved(kPivot + dvec3(0, 0, side * 0.118)) *
                                               turned(90 * side, {1, 0, 0})));
  }
  model.add("rear axle", "steel",
            tube({kRearAxle - dvec3(0, 0, 0.11), kRearAxle + dvec3(0, 0, 0.11)}, 0.011, 20));
}

}  // namespace glimt::assets::motorcycle
