#include <cmath>

#include "assets/generate/geometry/curve.h"
#include "assets/generate/geometry/hull.h"
#include "assets/generate/geometry/solids.h"
#include "assets/generate/motorcycle/parts.h"

namespace glimt::assets::motorcycle {
namespace {

// A bump of height 1 at 0 that is gone at 1.
double bump(double x) {
  const double t = std::max(0.0, 1 - x * x);
  return t * t;
}

// Hollows for the knees.
dvec3 kneeHollow(const dvec3& p) {
  const double depth = 0.026 * bump((p.x + 0.055) / 0.125) * bump((p.y - 0.825) / 0.085);
  return {p.x, p.y, p.z - std::copysign(std::min(depth, std::abs(p.z)), p.z)};
}

Hull tank() {
  return Hull({{-0.185, 0.070, 0.838, 0.770, 2.6},
               {-0.10, 0.098, 0.880, 0.762, 2.9},
               {0.00, 0.126, 0.928, 0.755, 3.0},
               {0.10, 0.143, 0.962, 0.750, 2.9},
               {0.20, 0.143, 0.972, 0.752, 2.7},
               {0.28, 0.118, 0.955, 0.772, 2.5},
               {0.355, 0.080, 0.905, 0.806, 2.4}},
              5.5, kneeHollow);
}

void addTank(Model& model) {
  const Hull hull = tank();
  model.add("tank", "paint", hull.mesh(84, 112), 60);
  // A panel of the second colour along the side, and a line around it.
  const auto low = [](double t) { return 74 + 10 * std::sin(3.0 * t); };
  const auto high = [](double t) { return 122 - 26 * (1 - t) * (1 - t) - 12 * t * t; };
  Mesh panels, lines;
  for (const double side : {1.0, -1.0}) {
    const auto mirrored = [&](double around) { return side > 0 ? around : 360 - around; };
    const auto strip = [&](const std::function<double(double)>& from,
                           const std::function<double(double)>& to, double lift) {
      return side > 0 ? hull.band(0.055, 0.945, from, to, lift, 70, 8)
                      : hull.band(
                            0.055, 0.945, [&](double t) { return mirrored(to(t)); },
                            [&](double t) { return mirrored(from(t)); }, lift, 70, 8);
    };
    append(panels, strip(low, high, 0.0004));
    append(lines, strip([&](double t) { return low(t) - 3.2; },
                        [&](double t) { return low(t) - 1.8; }, 0.0004));
    append(lines, strip([&](double t) { return high(t) + 1.6; },
                        [&](double t) { return high(t) + 3.0; }, 0.0004));
  }
  model.add("tank panels", "accent", panels, 60);
  model.add("tank lines", "line", lines, 60);
  const Mesh cap = lathe({{0.034, -0.004},
                          {0.036, 0.004},
                          {0.036, 0.010},
                          {0.032, 0.014},
                          {0.020, 0.016},
                          {0.018, 0.020},
                          {0, 0.021}},
                         56);
  const dmat4 on_top = pointing(hull.at(0.72, 0), hull.normal(0.72, 0));
  model.add("fuel cap", "chrome", transformed(cap, on_top));
  model.add(
      "fuel cap lever", "chrome",
      transformed(roundedBox({0.052, 0.006, 0.010}, 0.0028, 3), on_top * moved({0, 0.022, 0})));
}

// Ovals of the tank's paint below the seat.
void addSidePanels(Model& model) {
  for (const double side : {1.0, -1.0}) {
    std::vector<dvec2> outline = superellipse(0.118, 0.088, 2.7, 72);
    for (dvec2& p : outline) p = {p.x + 0.35 * p.y * 0.6, p.y * (1 - 0.9 * p.x)};
    const dmat4 place = moved({-0.335, 0.625, side * 0.106}) * scaled({1, 1, side});
    model.add("side panel", "paint", transformed(cover(outline, 0.026, 0.018, 10), place), 60);
    std::vector<dvec2> inner = outline;
    for (dvec2& p : inner) p *= 0.60;
    model.add("side panel badge", "accent", transformed(cover(inner, 0.0285, 0.002, 3), place));
    for (const dvec2& at : {dvec2(0.075, 0.02), dvec2(-0.085, -0.005)})
      model.add("side panel screw", "chrome",
                transformed(cylinder(0.006, 0.02, 0.029, 0.002, 20),
                            place * moved({at, 0}) * turned(90, {1, 0, 0})));
  }
}

// The hump behind the seat.
void addTail(Model& model) {
  const Hull hull({{-0.900, 0.060, 0.850, 0.795, 2.3},
                   {-0.84, 0.102, 0.892, 0.768, 2.5},
                   {-0.75, 0.128, 0.912, 0.752, 2.7},
                   {-0.66, 0.136, 0.900, 0.750, 2.9},
                   {-0.585, 0.134, 0.850, 0.752, 3.0}},
                  6);
  model.add("tail", "paint", hull.mesh(56, 84), 60);
  Mesh lines;
  for (const auto& [from, to] : {std::pair{-24.0, -12.0}, {12.0, 24.0}})
    append(lines, hull.band(
                      0.08, 0.93, [f = from](double) { return f; }, [t = to](double) { return t; },
                      0.0004, 60, 4));
  model.add("tail lines", "accent", lines, 60);
}

}  // namespace

void addBodywork(Model& model) {
  addTank(model);
  addSidePanels(model);
  addTail(model);
}

}  // namespace glimt::assets::motorcycle
