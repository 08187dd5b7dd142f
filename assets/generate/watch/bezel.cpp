#include <cmath>

#include "assets/generate/geometry/curve.h"
#include "assets/generate/geometry/grid.h"
#include "assets/generate/geometry/solids.h"
#include "assets/generate/watch/parts.h"

namespace glimt::assets::watch {
namespace {

constexpr double mm = kMillimetre;
constexpr double kInsertInner = 16.7 * mm, kInsertOuter = 19.5 * mm;
constexpr double kInsertLow = 1.75 * mm, kInsertHigh = 2.35 * mm;

// A ring with a coin's edge.
Mesh coinEdge() {
  constexpr int kNotches = 120, kAround = kNotches * 6;
  const double radii[] = {19.6, 20.3, 20.7, 20.7, 20.3, 19.6};
  const double heights[] = {-0.1, -0.05, 0.3, 1.45, 1.75, 1.8};
  return grid(kAround, 5, Edges::closed, Edges::open, [&](int i, int j) {
    const double angle = glm::radians(360.0 * i / kAround);
    const double notch = j == 2 || j == 3 ? 0.16 * std::cos(kNotches * angle) : 0;
    const double r = (radii[j] + notch) * mm;
    return dvec3(r * std::cos(angle), heights[j] * mm, -r * std::sin(angle));
  });
}

// The insert's slope, at a distance from the middle.
double insertHeight(double radius) {
  return glm::mix(kInsertHigh, kInsertLow, (radius - kInsertInner) / (kInsertOuter - kInsertInner));
}

// What is printed on the insert: a patch between two radii, so many minutes wide at each.
Mesh print(double minute, double inner, double outer, double inner_minutes, double outer_minutes) {
  return grid(4, 4, Edges::open, Edges::open, [&](int i, int j) {
    const double t = j / 4.0, r = glm::mix(inner, outer, t);
    const double width = glm::mix(inner_minutes, outer_minutes, t);
    return onDial(minute + width * (i / 4.0 - 0.5), r, insertHeight(r) + 0.03 * mm);
  });
}

Mesh scale() {
  Mesh all = print(0, kInsertInner + 0.45 * mm, kInsertOuter - 0.3 * mm, 0.06, 1.7);
  for (int minute = 1; minute < 60; ++minute) {
    const bool ten = minute % 10 == 0, five = minute % 5 == 0;
    const double from = ten    ? kInsertInner + 0.5 * mm
                        : five ? kInsertInner + 0.9 * mm
                               : kInsertInner + 1.55 * mm;
    const double to = kInsertOuter - (five ? 0.35 : 0.85) * mm;
    const double width = ten ? 0.62 : five ? 0.40 : 0.11;
    append(all, print(minute, from, to, width * 1.08, width));
  }
  return all;
}

}  // namespace

void addBezel(Model& model) {
  model.add("bezel", "metal", coinEdge());
  model.add("bezel edge", "metal",
            transformed(torus(19.62 * mm, 0.14 * mm, 160, 16), moved({0, 1.78 * mm, 0})));
  model.add("bezel insert", "bezel",
            lathe({{kInsertOuter, kInsertLow}, {kInsertInner, kInsertHigh}}, 180));
  model.add("bezel scale", "bezel print", scale());
  // The lip that holds the crystal.
  model.add("crystal seat", "metal",
            lathe({{kInsertInner + 0.02 * mm, kInsertHigh - 0.02 * mm},
                   {kInsertInner - 0.1 * mm, 2.55 * mm},
                   {16.35 * mm, 2.55 * mm},
                   {16.25 * mm, 2.40 * mm},
                   {16.25 * mm, 0.9 * mm}},
                  160));
  model.add("crystal", "crystal",
            lathe({{16.25 * mm, 2.35 * mm},
                   {16.15 * mm, 2.7 * mm},
                   {15.8 * mm, 2.88 * mm},
                   {12 * mm, 3.0 * mm},
                   {6 * mm, 3.1 * mm},
                   {0, 3.13 * mm}},
                  128),
            50);
}

}  // namespace glimt::assets::watch
