#include <cmath>

#include "assets/generate/geometry/curve.h"
#include "assets/generate/geometry/solids.h"
#include "assets/generate/motorcycle/parts.h"
#include "assets/generate/motorcycle/tyre.h"

namespace glimt::assets::motorcycle {
namespace {

struct WheelSize {
  double bead;  // radius of the rim's edge
  double tyre_width;
  double rim_half_width;
  double hub_radius, hub_half_width;
};

Mesh rim(const WheelSize& size) {
  const double w = size.rim_half_width, r = size.bead;
  return lathe({{r - 0.010, -w + 0.003},
                {r - 0.022, -0.6 * w},
                {r - 0.028, -0.25 * w},
                {r - 0.029, 0},
                {r - 0.028, 0.25 * w},
                {r - 0.022, 0.6 * w},
                {r - 0.010, w - 0.003},
                {r + 0.002, w - 0.001},
                {r + 0.006, w + 0.002},
                {r + 0.008, w},
                {r + 0.006, w - 0.004},
                {r - 0.012, 0.5 * w},
                {r - 0.014, 0},
                {r - 0.012, -0.5 * w},
                {r + 0.006, -w + 0.004},
                {r + 0.008, -w},
                {r + 0.006, -w - 0.002},
                {r + 0.002, -w + 0.001},
                {r - 0.010, -w + 0.003}},
               160);
}

// From the hub's flange to the rim: forty wires that cross each other, each with its nipple.
void addSpokes(const WheelSize& size, Mesh& spokes, Mesh& nipples) {
  constexpr int kPairs = 20;
  for (int i = 0; i < 2 * kPairs; ++i) {
    const double side = i % 2 == 0 ? 1 : -1;
    const double lean = (i / 2) % 2 == 0 ? 1 : -1;
    const double on_rim = glm::radians(360.0 * i / (2 * kPairs));
    const double on_hub = on_rim + lean * glm::radians(38.0);
    const auto at = [](double radius, double angle, double y) {
      return dvec3(radius * std::cos(angle), y, radius * std::sin(angle));
    };
    const dvec3 inner = at(size.hub_radius, on_hub, side * size.hub_half_width);
    const dvec3 outer = at(size.bead - 0.026, on_rim, side * 0.2 * size.rim_half_width);
    append(spokes, tube({inner, outer}, 0.0019, 8));
    const dvec3 inward = glm::normalize(inner - outer);
    append(nipples, tube({outer - 0.004 * inward, outer + 0.018 * inward}, 0.0036, 8));
  }
}

Mesh hub(const WheelSize& size) {
  const double h = size.hub_half_width, r = size.hub_radius;
  return lathe({{0, -h - 0.022},
                {0.020, -h - 0.022},
                {0.022, -h - 0.004},
                {r + 0.005, -h - 0.003},
                {r + 0.006, -h},
                {r + 0.005, -h + 0.003},
                {0.62 * r, -0.6 * h},
                {0.56 * r, 0},
                {0.62 * r, 0.6 * h},
                {r + 0.005, h - 0.003},
                {r + 0.006, h},
                {r + 0.005, h + 0.003},
                {0.022, h + 0.004},
                {0.020, h + 0.022},
                {0, h + 0.022}},
               64);
}

void addWheel(Model& model, const std::string& name, const dvec3& axle, const WheelSize& size) {
  const dmat4 place = moved(axle) * turned(90, {1, 0, 0});
  model.add(name + " tyre", "rubber",
            transformed(tyre(kWheelRadius, size.bead, size.tyre_width, 480), place), 50);
  model.add(name + " rim", "rim", transformed(rim(size), place));
  Mesh spokes, nipples;
  addSpokes(size, spokes, nipples);
  model.add(name + " spokes", "steel", transformed(spokes, place));
  model.add(name + " nipples", "brass", transformed(nipples, place));
  model.add(name + " hub", "cast alloy", transformed(hub(size), place));
  const Mesh valve = tube({{size.bead - 0.03, 0, 0}, {size.bead - 0.065, 0, 0}}, 0.0035, 10);
  model.add(name + " valve", "steel", transformed(valve, place * turned(200, {0, 1, 0})));
}

}  // namespace

void addWheels(Model& model) {
  addWheel(model, "front", kFrontAxle, {0.232, 0.105, 0.032, 0.052, 0.040});
  addWheel(model, "rear", kRearAxle, {0.226, 0.135, 0.043, 0.062, 0.048});
}

}  // namespace glimt::assets::motorcycle
