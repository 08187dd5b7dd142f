#include <cmath>

#include "assets/generate/geometry/curve.h"
#include "assets/generate/geometry/solids.h"
#include "assets/generate/motorcycle/parts.h"

namespace glimt::assets::motorcycle {

dvec3 forkDirection() {
  return {-std::sin(glm::radians(kRake)), std::cos(glm::radians(kRake)), 0};
}

dvec3 onFork(double above_axle, double forward, double z) {
  const dvec3 up = forkDirection();
  return kFrontAxle + above_axle * up + forward * dvec3(up.y, -up.x, 0) + dvec3(0, 0, z);
}

namespace {

// Bellows of rubber: a profile of folds that narrows upwards.
Mesh gaiter(double length) {
  constexpr int kFolds = 13, kSteps = 6;
  std::vector<dvec2> profile{{0.030, -0.004}, {0.034, -0.004}};
  for (int k = 0; k <= kFolds * kSteps; ++k) {
    const double t = static_cast<double>(k) / (kFolds * kSteps);
    const double fold = 0.5 - 0.5 * std::cos(2 * glm::radians(180.0) * k / kSteps);
    profile.emplace_back(glm::mix(0.031, 0.0255, t) + 0.0055 * fold, t * length);
  }
  profile.emplace_back(0.027, length + 0.006);
  profile.emplace_back(0.021, length + 0.006);
  return lathe(profile, 48);
}

Mesh slider() {
  return lathe({{0, -0.030},
                {0.022, -0.030},
                {0.025, -0.026},
                {0.0265, 0.020},
                {0.0275, 0.060},
                {0.0275, 0.245},
                {0.0300, 0.250},
                {0.0300, 0.268},
                {0.0280, 0.272},
                {0.0200, 0.272}},
               48);
}

// The outline of a yoke, seen along the fork: two eyes and a web.
std::vector<dvec2> yokeOutline(double spread, double eye, double waist) {
  std::vector<dvec2> outline;
  const auto arc = [&](double center, double from, double to) {
    for (int k = 0; k <= 12; ++k) {
      const double a = glm::radians(glm::mix(from, to, k / 12.0));
      outline.emplace_back(center + eye * std::cos(a), eye * std::sin(a));
    }
  };
  arc(spread, -110, 110);
  outline.emplace_back(0.03, waist);
  outline.emplace_back(-0.03, waist);
  arc(-spread, 70, 290);
  outline.emplace_back(-0.03, -waist * 1.5);
  outline.emplace_back(0.03, -waist * 1.5);
  return outline;
}

// Lies across the fork at a height along it.
Mesh yoke(double above_axle, double thick, double waist) {
  const dvec3 up = forkDirection(), front(up.y, -up.x, 0), right(0, 0, 1);
  const dmat4 place{glm::dvec4(right, 0), glm::dvec4(front, 0), glm::dvec4(-up, 0),
                    glm::dvec4(onFork(above_axle, 0, 0), 1)};
  return transformed(plate(yokeOutline(kForkSpread, 0.034, waist), thick, 0.004), place);
}

}  // namespace

void addFork(Model& model) {
  for (const double side : {1.0, -1.0}) {
    const std::string name = side > 0 ? "right fork" : "left fork";
    const double z = side * kForkSpread;
    const dmat4 place = pointing(onFork(0, 0, z), forkDirection());
    model.add(name + " slider", "polished alloy", transformed(slider(), place));
    model.add(name + " tube", "chrome",
              transformed(cylinder(0.0205, 0.26, 0.735, 0.003, 40), place));
    model.add(name + " gaiter", "black rubber",
              transformed(gaiter(0.20), place * moved({0, 0.272, 0})));
    model.add(
        name + " cap", "polished alloy",
        transformed(
            lathe({{0.021, 0}, {0.021, 0.006}, {0.013, 0.010}, {0.013, 0.020}, {0, 0.020}}, 6),
            place * moved({0, 0.735, 0})));
  }
  model.add("lower yoke", "black metal", yoke(0.535, 0.034, 0.034));
  model.add("upper yoke", "polished alloy", yoke(0.725, 0.022, 0.022));
  const dmat4 stem = pointing(onFork(0, -0.055, 0), forkDirection());
  model.add(
      "steering stem nut", "chrome",
      transformed(lathe({{0.024, 0.70}, {0.024, 0.722}, {0.018, 0.735}, {0, 0.735}}, 24), stem));
  const Mesh axle = transformed(cylinder(0.012, -0.132, 0.132, 0.003, 24),
                                moved(kFrontAxle) * turned(90, {1, 0, 0}));
  model.add("front axle", "steel", axle);
  for (const double side : {1.0, -1.0})
    model.add("front axle nut", "chrome",
              transformed(boltHead(0.030), moved(kFrontAxle + dvec3(0, 0, side * 0.125)) *
                                               turned(90 * side, {1, 0, 0})));
}

}  // namespace glimt::assets::motorcycle
