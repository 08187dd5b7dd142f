#include <algorithm>
#include <cmath>

#include "assets/generate/geometry/curve.h"
#include "assets/generate/geometry/hull.h"
#include "assets/generate/motorcycle/parts.h"

namespace glimt::assets::motorcycle {
namespace {

constexpr double kFirstRib = -0.58, kRib = 0.040, kLastRib = -0.20;

// Tufts across the seat, pulled in at the seams between them.
dvec3 tufted(const dvec3& p) {
  if (p.y < 0.775) return p;
  const double to_seam = std::abs(std::remainder(p.x - kFirstRib, kRib)) / (0.5 * kRib);
  const double within = glm::smoothstep(kFirstRib - 0.01, kFirstRib, p.x) *
                        (1 - glm::smoothstep(kLastRib, kLastRib + 0.01, p.x));
  const double edge = glm::smoothstep(0.775, 0.80, p.y);
  const double pulled = 0.0085 * std::pow(1 - std::min(1.0, to_seam), 2.2);
  return {p.x, p.y - pulled * within * edge, p.z};
}

Hull cushion() {
  return Hull({{-0.640, 0.124, 0.830, 0.757, 3.4},
               {-0.55, 0.130, 0.824, 0.757, 3.4},
               {-0.42, 0.127, 0.815, 0.757, 3.2},
               {-0.28, 0.112, 0.815, 0.757, 3.0},
               {-0.19, 0.094, 0.824, 0.760, 2.8},
               {-0.125, 0.078, 0.836, 0.770, 2.6}},
              9, tufted);
}

}  // namespace

void addSeat(Model& model) {
  const Hull hull = cushion();
  model.add("seat", "leather", hull.mesh(170, 72), 60);
  for (const double around : {100.0, 260.0}) {
    Path piping;
    for (int k = 0; k <= 100; ++k)
      piping.push_back(hull.at(glm::mix(0.015, 0.985, k / 100.0), around) - dvec3(0, 0.001, 0));
    model.add("seat piping", "piping", tube(piping, 0.0030, 10));
  }
}

}  // namespace glimt::assets::motorcycle
