#include <algorithm>

#include "assets/generate/geometry/curve.h"
#include "assets/generate/geometry/grid.h"
#include "assets/generate/geometry/solids.h"
#include "assets/generate/watch/parts.h"

namespace glimt::assets::watch {
namespace {

constexpr double mm = kMillimetre;

// Small dials: where, and how many marks they carry.
struct SubDial {
  dvec2 at;  // millimetres to the right, and down
  int marks;
  double hand;  // degrees clockwise from the top
};
constexpr double kSubDialRadius = 4.1 * mm;
const SubDial kSubDials[] = {{{7.4, 0}, 30, 205}, {{-7.4, 0}, 60, 48}, {{0, 7.4}, 12, 300}};

// A flat mark along -z, that stands on y = 0.
Mesh mark(double inner, double outer, double width, double height) {
  return transformed(roundedBox({width, height, outer - inner}, 0.25 * std::min(width, height), 1),
                     moved({0, 0.5 * height, -0.5 * (inner + outer)}));
}

Mesh aroundDial(const Mesh& mesh, int count) {
  return aroundAxis(mesh, count, {0, -1, 0});
}

// Batons of metal with a bar of luminous paint on each; two at 12.
void addHours(Model& model) {
  Mesh batons, paint;
  const auto add = [&](double minute, double shift, double inner, double width) {
    const dmat4 place = atMinute(minute) * moved({shift, 0, 0});
    append(batons, transformed(mark(inner, 14.4 * mm, width, 0.55 * mm), place));
    append(paint, transformed(mark(inner + 0.3 * mm, 14.1 * mm, 0.55 * width, 0.04 * mm),
                              place * moved({0, 0.545 * mm, 0})));
  };
  for (int hour = 1; hour < 12; ++hour)
    add(5 * hour, 0, (hour % 3 == 0 ? 12.1 : 11.0) * mm, 1.15 * mm);
  add(0, -0.85 * mm, 10.6 * mm, 1.2 * mm);
  add(0, 0.85 * mm, 10.6 * mm, 1.2 * mm);
  model.add("hour marks", "trim", batons);
  model.add("luminous paint", "luminous", paint);
}

void addSubDial(Model& model, const SubDial& sub) {
  const dmat4 place = moved({sub.at.x * mm, 0, sub.at.y * mm});
  const auto add = [&](const char* name, const char* material, const Mesh& mesh) {
    model.add(name, material, transformed(mesh, place));
  };
  const double r = kSubDialRadius;
  add("small dial", "small dial", lathe({{r, 0.07 * mm}, {0, 0.07 * mm}}, 72));
  add("small dial ring", "trim",
      transformed(ring(r - 0.05 * mm, r + 0.17 * mm, 0, 0.16 * mm, 0.04 * mm, 96), dmat4(1)));
  add("small dial marks", "print",
      transformed(aroundDial(mark(r - 0.75 * mm, r - 0.2 * mm, 0.09 * mm, 0.02 * mm), sub.marks),
                  moved({0, 0.08 * mm, 0})));
  add("small dial long marks", "print",
      transformed(aroundDial(mark(r - 1.05 * mm, r - 0.2 * mm, 0.15 * mm, 0.02 * mm),
                             sub.marks == 30   ? 6
                             : sub.marks == 60 ? 12
                                               : 4),
                  moved({0, 0.085 * mm, 0})));
  const dmat4 turn = turned(-sub.hand, {0, 1, 0});
  add("small hand", "hands",
      transformed(joined({mark(-0.9 * mm, 3.1 * mm, 0.26 * mm, 0.12 * mm),
                          cylinder(0.42 * mm, 0, 0.2 * mm, 0.05 * mm, 32)}),
                  turn * moved({0, 0.28 * mm, 0})));
}

}  // namespace

void addDial(Model& model) {
  model.add("dial", "dial", lathe({{kDialRadius, 0}, {0, 0}}, 128));
  // The slope between dial and crystal carries the minutes.
  model.add(
      "dial slope", "dial slope",
      lathe({{16.3 * mm, 1.5 * mm}, {16.2 * mm, 1.35 * mm}, {kDialRadius - 0.6 * mm, 0.02 * mm}},
            128));
  Mesh minutes = aroundDial(mark(14.55 * mm, 14.95 * mm, 0.10 * mm, 0.02 * mm), 300);
  append(minutes, aroundDial(mark(14.3 * mm, 14.95 * mm, 0.17 * mm, 0.02 * mm), 60));
  model.add("minute marks", "print", minutes);
  addHours(model);
  for (const SubDial& sub : kSubDials) addSubDial(model, sub);
}

}  // namespace glimt::assets::watch
