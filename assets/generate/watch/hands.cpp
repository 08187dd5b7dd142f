#include "assets/generate/geometry/curve.h"
#include "assets/generate/geometry/grid.h"
#include "assets/generate/geometry/solids.h"
#include "assets/generate/watch/parts.h"

namespace glimt::assets::watch {
namespace {

constexpr double mm = kMillimetre;

// A blade along -z with a ridge in its middle.
Mesh blade(double tail, double length, double width, double thick) {
  const std::vector<dvec2> outline{
      {-0.55 * width, tail},           {0.55 * width, tail},           {0.62 * width, 0},
      {0.5 * width, -0.35 * length},   {0.42 * width, -0.93 * length}, {0, -length},
      {-0.42 * width, -0.93 * length}, {-0.5 * width, -0.35 * length}, {-0.62 * width, 0}};
  // Two rings of edges, and a ridge that the upper one is drawn up to.
  const int corners = static_cast<int>(outline.size());
  return grid(corners, 2, Edges::closed, Edges::open, [&](int i, int j) {
    const dvec2 p = outline[corners - 1 - i];
    if (j < 2) return dvec3(p.x, j == 0 ? 0 : 0.35 * thick, p.y);
    return dvec3(0, thick, glm::clamp(p.y, -0.96 * length, 0.9 * tail));
  });
}

Mesh paintStrip(double from, double to, double width, double height) {
  return transformed(roundedBox({width, 0.05 * mm, to - from}, 0.02 * mm, 2),
                     moved({0, height, -0.5 * (from + to)}));
}

void addHand(Model& model, const std::string& name, double minute, double height, double length,
             double width, double paint_from) {
  const dmat4 place = atMinute(minute) * moved({0, height, 0});
  model.add(name, "hands", transformed(blade(3.0 * mm, length, width, 0.28 * mm), place), 15);
  model.add(name + " paint", "luminous",
            transformed(paintStrip(paint_from, 0.88 * length, 0.5 * width, 0.285 * mm), place));
}

}  // namespace

void addHands(Model& model) {
  // Eight and a half minutes past ten, as all watches in shops.
  addHand(model, "hour hand", 50.0 + 8.5 / 12, 0.75 * mm, 9.4 * mm, 1.5 * mm, 3.4 * mm);
  addHand(model, "minute hand", 8.5, 1.15 * mm, 13.6 * mm, 1.25 * mm, 4.2 * mm);
  const dmat4 seconds = atMinute(36) * moved({0, 1.6 * mm, 0});
  Mesh second = transformed(roundedBox({0.24 * mm, 0.14 * mm, 18.6 * mm}, 0.05 * mm, 2),
                            moved({0, 0, -4.9 * mm}));
  append(second, transformed(cylinder(0.95 * mm, -0.08 * mm, 0.08 * mm, 0.04 * mm, 40),
                             moved({0, 0, 3.4 * mm})));
  append(second, cylinder(0.75 * mm, -0.1 * mm, 0.16 * mm, 0.05 * mm, 40));
  model.add("second hand", "second hand", transformed(second, seconds));
  model.add("hands' pin", "trim", cylinder(0.42 * mm, 0, 1.9 * mm, 0.08 * mm, 32));
}

}  // namespace glimt::assets::watch
