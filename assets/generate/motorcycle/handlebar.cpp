#include "assets/generate/geometry/curve.h"
#include "assets/generate/geometry/solids.h"
#include "assets/generate/motorcycle/parts.h"

namespace glimt::assets::motorcycle {
namespace {

const dvec3 kGripInner{0.318, 1.082, 0.255}, kGripOuter{0.270, 1.070, 0.378};

Mesh grip(double length) {
  constexpr int kRibs = 15;
  std::vector<dvec2> profile{{0.0115, -0.002}, {0.020, -0.002}, {0.020, 0.003}, {0.0165, 0.005}};
  for (int k = 0; k < kRibs; ++k) {
    const double y = 0.008 + (length - 0.016) * k / kRibs, step = (length - 0.016) / kRibs;
    profile.emplace_back(0.0172, y + 0.2 * step);
    profile.emplace_back(0.0172, y + 0.6 * step);
    profile.emplace_back(0.0156, y + 0.8 * step);
  }
  profile.emplace_back(0.0175, length - 0.004);
  profile.emplace_back(0.0175, length + 0.002);
  profile.emplace_back(0, length + 0.004);
  return lathe(profile, 36);
}

// A lever in front of the grip, on a perch that holds it; with a fluid's reservoir on it.
void addLever(Model& model) {
  const dvec3 along = glm::normalize(kGripOuter - kGripInner);
  const dvec3 perch = kGripInner - 0.045 * along;
  model.add("lever perches", "black metal",
            withMirrorImage(joined(
                {transformed(cylinder(0.0185, -0.017, 0.017, 0.004, 32), pointing(perch, along)),
                 transformed(roundedBox({0.05, 0.020, 0.030}, 0.008, 3),
                             moved(perch + dvec3(0.025, 0, 0)))})));
  model.add("levers", "polished alloy",
            withMirrorImage(sweep(
                smoothPath({perch + dvec3(0.042, 0, 0.0), perch + dvec3(0.058, 0, 0.03),
                            kGripInner + dvec3(0.062, -0.004, 0.035),
                            glm::mix(kGripInner, kGripOuter, 0.7) + dvec3(0.052, -0.008, 0),
                            kGripOuter + dvec3(0.058, -0.010, 0.004)},
                           12),
                superellipse(0.0075, 0.0048, 2.6, 20), {0, 1, 0},
                [](double t) { return 1.15 - 0.3 * t; }, true)));
  model.add("lever tips", "polished alloy",
            withMirrorImage(
                transformed(sphere(0.0085, 20), moved(kGripOuter + dvec3(0.058, -0.010, 0.004)))));
  model.add("reservoir", "black metal",
            transformed(roundedBox({0.048, 0.034, 0.056}, 0.012, 4),
                        moved(perch + dvec3(0.035, 0.026, -0.004))));
  model.add("reservoir lid", "polished alloy",
            transformed(roundedBox({0.046, 0.006, 0.054}, 0.0028, 3),
                        moved(perch + dvec3(0.035, 0.045, -0.004))));
}

void addMirrors(Model& model) {
  const dvec3 perch = kGripInner + dvec3(0.02, 0.01, -0.055), middle(0.300, 1.225, 0.300);
  const dmat4 place = pointing(middle, glm::normalize(dvec3(1, 0.12, 0.30)));
  const Mesh shell = lathe({{0.054, -0.010},
                            {0.0565, -0.007},
                            {0.056, 0.000},
                            {0.050, 0.010},
                            {0.036, 0.019},
                            {0.018, 0.024},
                            {0, 0.025}},
                           72);
  model.add("mirror shells", "chrome", withMirrorImage(transformed(shell, place)));
  model.add("mirror glasses", "mirror",
            withMirrorImage(transformed(lathe({{0, -0.0085}, {0.054, -0.0095}}, 72), place)));
  model.add("mirror stems", "chrome",
            withMirrorImage(tube(smoothPath({perch,
                                             perch + dvec3(0.006, 0.05, 0.01),
                                             {0.322, 1.19, 0.272},
                                             middle + dvec3(0.012, -0.012, 0.002)},
                                            12),
                                 0.0052, 16)));
}

void addCables(Model& model) {
  const dvec3 perch = kGripInner + dvec3(0.07, 0, -0.05);
  const Path clutch = smoothPath({{perch.x, perch.y, -perch.z},
                                  {0.46, 1.085, -0.14},
                                  {0.47, 0.98, -0.06},
                                  {0.36, 0.80, -0.085},
                                  {0.27, 0.60, -0.125},
                                  {0.12, 0.47, -0.125}},
                                 14);
  const Path brake =
      smoothPath({perch, {0.47, 1.09, 0.14}, {0.495, 1.00, 0.07}, onFork(0.70, 0.06, 0.03)}, 14);
  model.add("cables", "black rubber", joined({tube(clutch, 0.0036, 10), tube(brake, 0.0040, 10)}));
}

}  // namespace

void addHandlebar(Model& model) {
  const Path bar = bentPath({kGripOuter * dvec3(1, 1, -1),
                             kGripInner * dvec3(1, 1, -1),
                             {0.345, 1.088, -0.185},
                             {0.385, 1.030, -0.095},
                             {0.385, 1.030, 0.095},
                             {0.345, 1.088, 0.185},
                             kGripInner,
                             kGripOuter},
                            0.07, 10);
  model.add("handlebar", "chrome", tube(bar, 0.0112, 28));
  const dvec3 along = kGripOuter - kGripInner;
  model.add("grips", "black rubber",
            withMirrorImage(transformed(grip(glm::length(along)), pointing(kGripInner, along))));
  for (const double z : {-0.045, 0.045}) {
    Mesh clamp = transformed(cylinder(0.020, -0.014, 0.014, 0.003, 36),
                             moved({0.385, 1.030, z}) * turned(90, {1, 0, 0}));
    append(clamp, transformed(cylinder(0.014, 0.72, 0.785, 0.002, 28),
                              pointing(onFork(0, 0.0, z), forkDirection())));
    model.add("handlebar clamp", "polished alloy", clamp);
  }
  addLever(model);
  addMirrors(model);
  addCables(model);
}

}  // namespace glimt::assets::motorcycle
