#include "assets/generate/geometry/curve.h"
#include "assets/generate/geometry/solids.h"
#include "assets/generate/motorcycle/parts.h"

namespace glimt::assets::motorcycle {
namespace {

constexpr double kTube = 0.0155;

// From the steering head down in front of the engine, below it, and up behind it.
Path cradle(double z) {
  return bentPath({onFork(0.60, -0.075, 0.25 * z),
                   {0.315, 0.70, 0.55 * z},
                   {0.245, 0.215, z},
                   {-0.225, 0.225, z},
                   {-0.255, 0.50, z},
                   {-0.235, 0.735, 0.8 * z}},
                  0.085, 10);
}

Path seatRail(double z) {
  return bentPath(
      {{-0.10, 0.735, 0.75 * z}, {-0.32, 0.738, z}, {-0.66, 0.742, z}, {-0.80, 0.775, 0.85 * z}},
      0.12, 10);
}

Path shockStay(double z) {
  return bentPath({{-0.255, 0.46, 0.95 * z}, {-0.42, 0.60, z}, {-0.60, 0.742, z}}, 0.1, 8);
}

}  // namespace

void addFrame(Model& model) {
  constexpr double kHalf = 0.105;
  Mesh frame = tube(
      bentPath({onFork(0.68, -0.075, 0), {0.22, 0.79, 0}, {-0.25, 0.735, 0}}, 0.2, 12), 0.022, 24);
  for (const double side : {1.0, -1.0}) {
    append(frame, tube(cradle(side * kHalf), kTube, 20));
    append(frame, tube(seatRail(side * kHalf), kTube, 20));
    append(frame, tube(shockStay(side * kHalf), 0.013, 20));
  }
  append(frame, tube(bentPath({{-0.795, 0.774, -0.09},
                               {-0.835, 0.79, -0.06},
                               {-0.835, 0.79, 0.06},
                               {-0.795, 0.774, 0.09}},
                              0.04, 6),
                     kTube, 20));
  for (const double x : {-0.25, -0.62})
    append(frame, tube({{x, 0.737, -kHalf}, {x, 0.737, kHalf}}, 0.013, 16));
  append(frame, tube({{-0.235, 0.28, -kHalf}, {-0.235, 0.28, kHalf}}, 0.013, 16));
  append(frame, tube({{0.235, 0.25, -kHalf}, {0.235, 0.25, kHalf}}, 0.013, 16));
  append(frame, transformed(cylinder(0.034, 0.515, 0.70, 0.004, 32),
                            pointing(onFork(0, -0.055, 0), forkDirection())));
  // Plates that carry the engine and the swing arm.
  for (const double side : {1.0, -1.0}) {
    const Mesh gusset =
        plate({{-0.275, 0.33}, {-0.18, 0.35}, {-0.17, 0.42}, {-0.235, 0.49}, {-0.28, 0.47}}, 0.006,
              0.001);
    append(frame, transformed(gusset, moved({0, 0, side * 0.116 - 0.003})));
  }
  model.add("frame", "frame", frame);
}

}  // namespace glimt::assets::motorcycle
