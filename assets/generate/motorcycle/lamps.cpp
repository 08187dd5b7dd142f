#include <cmath>

#include "assets/generate/geometry/curve.h"
#include "assets/generate/geometry/solids.h"
#include "assets/generate/motorcycle/parts.h"

namespace glimt::assets::motorcycle {
namespace {

const dvec3 kHeadlamp{0.565, 0.925, 0};  // of the rim's plane

std::vector<dvec2> arcProfile(double radius, double depth, int steps, double offset) {
  std::vector<dvec2> profile;
  for (int k = 0; k <= steps; ++k) {
    const double r = radius * (1 - static_cast<double>(k) / steps);
    profile.emplace_back(r, offset + depth * (1 - (r / radius) * (r / radius)));
  }
  return profile;
}

void addHeadlamp(Model& model) {
  const dmat4 place = pointing(kHeadlamp, {1, -0.03, 0});
  const auto add = [&](const std::string& name, const std::string& material, const Mesh& mesh) {
    model.add("headlamp " + name, material, transformed(mesh, place));
  };
  add("bowl", "headlamp",
      lathe({{0, -0.125},
             {0.022, -0.123},
             {0.048, -0.112},
             {0.070, -0.088},
             {0.083, -0.050},
             {0.0875, -0.012},
             {0.088, 0.0}},
            96));
  add("rim", "chrome",
      lathe({{0.088, -0.008},
             {0.0935, -0.006},
             {0.0955, 0.002},
             {0.0945, 0.012},
             {0.090, 0.018},
             {0.085, 0.019},
             {0.083, 0.015},
             {0.083, 0.004}},
            120));
  std::vector<dvec2> reflector;
  for (int k = 0; k <= 20; ++k) {
    const double r = 0.0835 - 0.0735 * k / 20;
    reflector.emplace_back(r, 0.006 - 0.062 * (1 - (r / 0.0835) * (r / 0.0835)));
  }
  reflector.emplace_back(0, -0.058);
  add("reflector", "mirror", lathe(reflector, 96));
  add("bulb shield", "chrome",
      lathe({{0.011, -0.020}, {0.013, -0.004}, {0.010, 0.004}, {0, 0.006}}, 40));
  add("bulb", "white", cylinder(0.007, -0.058, -0.012, 0.002, 24));
  add("glass", "clear glass", lathe(arcProfile(0.084, 0.014, 14, 0.015), 96));
  Mesh ears;
  for (const double side : {1.0, -1.0}) {
    const std::vector<dvec2> outline =
        beltOutline({0.545, 0.925}, 0.020, {0.447, 0.885}, 0.030, 16);
    append(ears, transformed(plate(outline, 0.005, 0.001), moved({0, 0, side * 0.0975 - 0.0025})));
    append(ears, transformed(cylinder(0.0285, 0.575, 0.665, 0.004, 36),
                             pointing(onFork(0, 0, side * kForkSpread), forkDirection())));
  }
  model.add("headlamp ears", "headlamp", ears);
  for (const double side : {1.0, -1.0})
    model.add("headlamp bolts", "chrome",
              transformed(boltHead(0.020),
                          moved({0.545, 0.925, side * 0.099}) * turned(90 * side, {1, 0, 0})));
}

void addIndicator(Model& model, const dvec3& root, double side, double forward) {
  const dvec3 middle = root + dvec3(0, 0, side * 0.075);
  const dmat4 place = pointing(middle, {forward, 0, 0});
  model.add("indicator stem", "chrome", tube({root - dvec3(0, 0, side * 0.02), middle}, 0.006, 16));
  model.add("indicator body", "chrome",
            transformed(lathe({{0, -0.046},
                               {0.012, -0.042},
                               {0.021, -0.028},
                               {0.0255, -0.006},
                               {0.0265, 0.004},
                               {0.0245, 0.006}},
                              48),
                        place));
  model.add("indicator lens", "amber",
            transformed(lathe(arcProfile(0.0245, 0.012, 10, 0.004), 48), place));
}

void addTailLamp(Model& model) {
  const dmat4 place = pointing({-0.900, 0.815, 0}, {-1, 0.12, 0});
  model.add("tail lamp body", "chrome",
            transformed(lathe({{0.024, -0.030}, {0.036, -0.012}, {0.038, 0.0}, {0.035, 0.004}}, 56),
                        place));
  model.add("tail lamp lens", "red lens",
            transformed(lathe(arcProfile(0.035, 0.016, 12, 0.002), 56), place));
}

}  // namespace

void addLamps(Model& model) {
  addHeadlamp(model);
  addTailLamp(model);
  for (const double side : {1.0, -1.0}) {
    addIndicator(model, onFork(0.60, 0.025, side * 0.125), side, 1);
    addIndicator(model, {-0.83, 0.775, side * 0.075}, side, -1);
  }
  model.add("horn", "black metal",
            transformed(lathe({{0, -0.04},
                               {0.03, -0.035},
                               {0.036, -0.02},
                               {0.045, 0.0},
                               {0.042, 0.004},
                               {0.028, -0.004},
                               {0.012, 0.004},
                               {0, 0.004}},
                              48),
                        pointing({0.335, 0.70, 0}, {1, -0.1, 0})));
}

}  // namespace glimt::assets::motorcycle
