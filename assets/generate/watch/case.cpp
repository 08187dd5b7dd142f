#include <cmath>

#include "assets/generate/geometry/curve.h"
#include "assets/generate/geometry/grid.h"
#include "assets/generate/geometry/solids.h"
#include "assets/generate/watch/parts.h"

namespace glimt::assets::watch {
namespace {

constexpr double mm = kMillimetre;

std::vector<dvec2> millimetres(std::vector<dvec2> profile) {
  for (dvec2& p : profile) p *= mm;
  return profile;
}

// From the case's middle outward and down, as wide as the strap leaves room for.
Mesh lug() {
  const Path path = smoothPath(
      {dvec3(11.7, -2.0, 14.0) * mm, dvec3(11.8, -1.7, 18.0) * mm, dvec3(11.9, -2.4, 21.5) * mm,
       dvec3(11.9, -4.4, 24.2) * mm, dvec3(11.9, -7.0, 25.2) * mm},
      14);
  return sweep(
      path, superellipse(1.65 * mm, 2.2 * mm, 5, 40), {0, 1, 0},
      [](double t) { return 1.05 - 0.25 * t * t; }, true);
}

// A wheel with ribs along +y, for fingers.
Mesh ribbed(double radius, double length, int ribs) {
  const int around = ribs * 6;
  return grid(around, 9, Edges::closed, Edges::open, [&](int i, int j) {
    const double angle = glm::radians(360.0 * i / around);
    const double rib = 0.055 * radius * std::cos(ribs * angle);
    const double heights[] = {0, 0, 0.06, 0.12, 0.5, 0.88, 0.94, 1, 1, 1};
    const double radii[] = {0, 0.86, 0.94, 1, 1, 1, 0.94, 0.86, 0.45, 0};
    const double r = radii[j] * (radius + (j >= 2 && j <= 6 ? rib : -0.05 * radius));
    return dvec3(r * std::cos(angle), length * heights[j], -r * std::sin(angle));
  });
}

void addCrown(Model& model) {
  const dmat4 place = pointing(onDial(15, kCaseRadius - 0.6 * mm, -2.6 * mm), {1, 0, 0});
  model.add("crown", "metal",
            transformed(ribbed(3.1 * mm, 3.8 * mm, 30), place * moved({0, 1.0 * mm, 0})));
  model.add("crown tube", "metal", transformed(cylinder(2.2 * mm, 0, 2 * mm, 0.1 * mm, 40), place));
  for (const double minute : {10.2, 19.8}) {
    const dvec3 out = onDial(minute, 1, 0);
    const dmat4 button = pointing(onDial(minute, kCaseRadius - 0.5 * mm, -2.6 * mm), out);
    model.add("push button", "metal",
              transformed(joined({cylinder(1.5 * mm, 0, 2.2 * mm, 0.15 * mm, 36),
                                  cylinder(2.25 * mm, 2.0 * mm, 4.3 * mm, 0.35 * mm, 48)}),
                          button));
  }
}

}  // namespace

dvec3 onDial(double minutes, double radius, double height) {
  const double angle = glm::radians(6 * minutes);
  return {radius * std::sin(angle), height, -radius * std::cos(angle)};
}

dmat4 atMinute(double minutes) {
  return turned(-6 * minutes, {0, 1, 0});
}

void addCase(Model& model) {
  model.add("case", "brushed metal",
            lathe(millimetres({{0, -6.6},
                               {15.5, -6.6},
                               {16.0, -6.4},
                               {16.2, -5.9},
                               {18.6, -5.6},
                               {19.8, -4.9},
                               {20.3, -4.2},
                               {20.5, -3.4},
                               {20.5, -1.2},
                               {20.35, -0.75},
                               {20.0, -0.5},
                               {16, -0.5}}),
                  160));
  model.add("case edge", "metal",
            lathe(millimetres(
                      {{20.15, -0.72}, {20.45, -0.55}, {20.45, -0.30}, {20.1, -0.1}, {19.5, -0.1}}),
                  160));
  Mesh lugs;
  for (const double x : {1.0, -1.0})
    for (const double z : {1.0, -1.0}) append(lugs, transformed(lug(), scaled({x, 1, z})));
  model.add("lugs", "brushed metal", lugs);
  Mesh bars;
  for (const double z : {1.0, -1.0})
    append(bars, tube({dvec3(-12.5, -5.4, 23.6 * z) * mm, dvec3(12.5, -5.4, 23.6 * z) * mm},
                      0.8 * mm, 20));
  model.add("spring bars", "metal", bars);
  addCrown(model);
}

}  // namespace glimt::assets::watch
