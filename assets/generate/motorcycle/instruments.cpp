#include "assets/generate/geometry/curve.h"
#include "assets/generate/geometry/solids.h"
#include "assets/generate/motorcycle/parts.h"

namespace glimt::assets::motorcycle {
namespace {

constexpr double kRadius = 0.042;

// Marks around a dial that lies in y = 0, every `step` degrees over three quarters of a turn.
Mesh marks(double step, double length, double width) {
  Mesh all;
  for (double angle = -45; angle <= 225.5; angle += step) {
    const Mesh mark = transformed(roundedBox({length, 0.0006, width}, 0.0002, 1),
                                  moved({0.86 * kRadius - 0.5 * length, 0, 0}));
    append(all, transformed(mark, turned(angle, {0, 1, 0})));
  }
  return all;
}

void addClock(Model& model, double z) {
  const dmat4 place = pointing(onFork(0.775, 0.062, z), glm::normalize(dvec3(-0.42, 0.9, 0)));
  const auto add = [&](const std::string& name, const std::string& material, const Mesh& mesh) {
    model.add("clock " + name, material, transformed(mesh, place));
  };
  add("cup", "chrome",
      lathe({{0, -0.058},
             {0.018, -0.058},
             {0.034, -0.050},
             {0.042, -0.034},
             {0.0445, 0.0},
             {0.047, 0.003},
             {0.047, 0.010},
             {0.044, 0.012},
             {0.042, 0.008},
             {0.042, 0.001}},
            72));
  add("dial", "dial", lathe({{kRadius, 0.0005}, {0, 0.0005}}, 48));
  add("marks", "white",
      transformed(joined({marks(13.5, 0.007, 0.0012), marks(6.75, 0.004, 0.0007)}),
                  moved({0, 0.001, 0})));
  add("needle", "needle",
      transformed(roundedBox({0.036, 0.001, 0.0018}, 0.0004, 1),
                  turned(205, {0, 1, 0}) * moved({0.012, 0.003, 0})));
  add("needle hub", "black metal", cylinder(0.004, 0.001, 0.005, 0.001, 24));
  add("glass", "clear glass", lathe({{0.043, 0.0095}, {0.03, 0.0102}, {0, 0.0105}}, 48));
}

}  // namespace

void addInstruments(Model& model) {
  addClock(model, -0.052);
  addClock(model, 0.052);
  model.add("clock bracket", "black metal",
            transformed(roundedBox({0.06, 0.006, 0.17}, 0.0028, 3),
                        pointing(onFork(0.735, 0.045, 0), {-0.42, 0.9, 0})));
}

}  // namespace glimt::assets::motorcycle
