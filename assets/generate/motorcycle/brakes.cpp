#include <cmath>
#include <numbers>

#include "assets/generate/geometry/curve.h"
#include "assets/generate/geometry/grid.h"
#include "assets/generate/geometry/solids.h"
#include "assets/generate/motorcycle/parts.h"

namespace glimt::assets::motorcycle {
namespace {

constexpr double kPi = std::numbers::pi;

// A piece of a ring between two radii and two angles, drilled through in its middle.
Mesh drilledPiece(double inner, double outer, double from, double to, double hole, double thick) {
  constexpr int kSteps = 16;
  const double radius = 0.5 * (inner + outer), angle = 0.5 * (from + to);
  const auto edge = [&](int i, double y) {
    const double a = 2 * kPi * (i + 0.5) / kSteps;
    const double reach = 1 / std::max(std::abs(std::cos(a)), std::abs(std::sin(a)));
    const double r = radius + 0.5 * (outer - inner) * reach * std::cos(a);
    const double t = angle + 0.5 * (to - from) * reach * std::sin(a);
    return dvec3(r * std::cos(t), y, -r * std::sin(t));
  };
  const auto rim = [&](int i, double y) {
    const double a = 2 * kPi * (i + 0.5) / kSteps;
    const double r = radius + hole * std::cos(a), t = angle + hole / radius * std::sin(a);
    return dvec3(r * std::cos(t), y, -r * std::sin(t));
  };
  return grid(kSteps, 3, Edges::closed, Edges::open, [&](int i, int j) {
    const double y = j < 2 ? 0.5 * thick : -0.5 * thick;
    return j == 0 || j == 3 ? edge(i, y) : rim(i, y);
  });
}

// About +y: three rows of holes, and arms to the hub.
Mesh brakeDisc(double inner, double outer, double thick) {
  constexpr int kRows = 3, kAround = 36;
  Mesh disc;
  for (int row = 0; row < kRows; ++row)
    for (int k = 0; k < kAround; ++k) {
      const double step = (outer - inner) / kRows, turn = 2 * kPi / kAround;
      const double from = turn * (k + row / 3.0);
      append(disc, drilledPiece(inner + row * step, inner + (row + 1) * step, from, from + turn,
                                0.0042, thick));
    }
  append(disc, lathe({{outer, -0.5 * thick}, {outer, 0.5 * thick}}, kAround * 3));
  append(disc, lathe({{inner, 0.5 * thick}, {inner, -0.5 * thick}}, kAround * 3));
  return disc;
}

Mesh carrier(double hub, double inner, double thick) {
  Mesh arms = ring(hub - 0.012, hub + 0.008, -thick, thick, 0.001, 48);
  for (int k = 0; k < 6; ++k) {
    const double length = inner + 0.008 - hub;
    const Mesh arm = transformed(roundedBox({length, 1.6 * thick, 0.022}, 0.0012, 2),
                                 moved({hub + 0.5 * length, 0, 0}));
    append(arms, transformed(arm, turned(60.0 * k, {0, 1, 0})));
  }
  return arms;
}

Mesh carrierBolts(double inner, double height) {
  const Mesh bolt = transformed(boltHead(0.011), moved({inner + 0.001, height, 0}));
  return aroundAxis(bolt, 6, {0, 1, 0});
}

void addDisc(Model& model, const std::string& name, const dvec3& at, double side, double inner,
             double outer) {
  const dmat4 place = moved(at) * turned(90 * side, {1, 0, 0});
  model.add(name + " disc", "disc steel", transformed(brakeDisc(inner, outer, 0.0045), place));
  model.add(name + " disc carrier", "black metal",
            transformed(carrier(0.052, inner, 0.003), place));
  model.add(name + " disc bolts", "steel", transformed(carrierBolts(inner, 0.003), place));
}

// Astride the disc, with two pistons' caps; made with the disc's centre below it.
Mesh caliper() {
  Mesh body = roundedBox({0.098, 0.062, 0.026}, 0.010, 4);
  append(body, transformed(roundedBox({0.112, 0.030, 0.040}, 0.008, 4), moved({0, 0.012, -0.014})));
  for (const double x : {-0.026, 0.026}) {
    const Mesh piston = cylinder(0.019, 0, 0.014, 0.003, 32);
    append(body, transformed(piston, moved({x, -0.004, 0.009}) * turned(90, {1, 0, 0})));
  }
  return body;
}

Mesh caliperBolts() {
  Mesh bolts;
  for (const double x : {-0.047, 0.047})
    append(bolts, transformed(boltHead(0.012), moved({x, 0.014, 0.006}) * turned(90, {1, 0, 0})));
  return bolts;
}

void addCaliper(Model& model, const std::string& name, const dvec3& axle, double angle,
                double radius, double z, double side) {
  const dmat4 place = moved({axle.x, axle.y, z}) * turned(angle, {0, 0, 1}) *
                      moved({0, radius, 0}) * scaled({1, 1, side});
  model.add(name + " caliper", "black metal", transformed(caliper(), place));
  model.add(name + " caliper bolts", "steel", transformed(caliperBolts(), place));
}

}  // namespace

void addBrakes(Model& model) {
  for (const double side : {1.0, -1.0}) {
    const std::string name = side > 0 ? "front right" : "front left";
    const double z = side * 0.066;
    addDisc(model, name, {kFrontAxle.x, kFrontAxle.y, z}, side, 0.105, 0.155);
    addCaliper(model, name, kFrontAxle, 62, 0.134, z, side);
    const Path hose =
        smoothPath({onFork(0.13, -0.05, side * 0.085), onFork(0.22, -0.055, side * 0.088),
                    onFork(0.40, -0.06, side * 0.075), onFork(0.58, 0.04, side * 0.04),
                    onFork(0.70, 0.06, side * 0.10)},
                   12);
    model.add(name + " hose", "black rubber", tube(hose, 0.0038, 10));
  }
  addDisc(model, "rear", {kRearAxle.x, kRearAxle.y, 0.075}, 1, 0.085, 0.128);
  addCaliper(model, "rear", kRearAxle, -60, 0.112, 0.075, 1);
}

}  // namespace glimt::assets::motorcycle
