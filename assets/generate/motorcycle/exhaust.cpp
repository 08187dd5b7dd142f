#include <cmath>

#include "assets/generate/geometry/curve.h"
#include "assets/generate/geometry/solids.h"
#include "assets/generate/motorcycle/parts.h"

namespace glimt::assets::motorcycle {
namespace {

const dvec3 kJoint{-0.27, 0.232, 0.172};  // of pipe and silencer, on the right
const dvec3 kOutlet{-0.86, 0.315, 0.192};

Path headerPipe() {
  return smoothPath({{0.155, 0.646, 0.072},
                     {0.205, 0.650, 0.078},
                     {0.268, 0.618, 0.098},
                     {0.296, 0.530, 0.122},
                     {0.290, 0.410, 0.142},
                     {0.258, 0.305, 0.153},
                     {0.180, 0.240, 0.160},
                     {0.060, 0.220, 0.165},
                     {-0.120, 0.224, 0.169},
                     kJoint},
                    14);
}

// A megaphone along +y that narrows to a rolled end; the inside is seen through it.
std::vector<dvec2> silencerProfile(double length) {
  return {{0.0195, -0.012},         {0.0235, -0.010},         {0.0240, 0.030},
          {0.0255, 0.036},          {0.031, 0.085},           {0.0375, 0.20},
          {0.0440, 0.36},           {0.0475, length - 0.115}, {0.0485, length - 0.095},
          {0.0475, length - 0.075}, {0.0425, length - 0.035}, {0.0345, length - 0.006},
          {0.0325, length},         {0.0300, length + 0.001}, {0.0285, length - 0.004},
          {0.0285, length - 0.10}};
}

}  // namespace

void addExhaust(Model& model) {
  const dvec3 along = kOutlet - kJoint;
  const double length = glm::length(along);
  const dmat4 place = pointing(kJoint, along);
  model.add("exhaust pipes", "exhaust", withMirrorImage(tube(headerPipe(), 0.0205, 40)));
  model.add("silencers", "exhaust",
            withMirrorImage(transformed(lathe(silencerProfile(length), 72), place)), 28);
  model.add("silencer insides", "soot",
            withMirrorImage(
                transformed(lathe({{0.0285, length - 0.10}, {0, length - 0.10}}, 32), place)));
  Mesh clamps = transformed(ring(0.023, 0.0275, -0.002, 0.014, 0.0015, 48), place);
  append(clamps, transformed(ring(0.019, 0.038, 0, 0.011, 0.002, 48),
                             pointing({0.148, 0.646, 0.0715}, {1, 0.06, 0.1})));
  for (int k = 0; k < 6; ++k) {  // cooling rose where the pipe leaves the head
    const double x = 0.163 + 0.008 * k;
    append(clamps, transformed(ring(0.020, 0.034 - 0.001 * k, 0, 0.003, 0.0008, 48),
                               pointing({x, 0.6475, 0.073 + 0.001 * k}, {1, 0.04, 0.12})));
  }
  model.add("exhaust clamps", "polished alloy", withMirrorImage(clamps));
  const dvec3 hanger = glm::mix(kJoint, kOutlet, 0.62);
  Mesh brackets = tube(
      {hanger + dvec3(0.02, 0.03, -0.02), {-0.60, 0.55, 0.118}, {-0.585, 0.70, 0.108}}, 0.008, 14);
  append(brackets, transformed(roundedBox({0.05, 0.03, 0.012}, 0.005, 2),
                               moved(hanger + dvec3(0.02, 0.035, -0.025))));
  model.add("exhaust brackets", "frame", withMirrorImage(brackets));
}

}  // namespace glimt::assets::motorcycle
