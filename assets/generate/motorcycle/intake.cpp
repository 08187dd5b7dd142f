#include <cmath>

#include "assets/generate/geometry/curve.h"
#include "assets/generate/geometry/solids.h"
#include "assets/generate/motorcycle/parts.h"

namespace glimt::assets::motorcycle {
namespace {

// Along +y from the engine: a rubber stub, the body with its flange and the filter's seat.
Mesh carburettorBody() {
  Mesh body = lathe({{0.020, 0.004},
                     {0.029, 0.006},
                     {0.029, 0.014},
                     {0.023, 0.016},
                     {0.023, 0.030},
                     {0.026, 0.032},
                     {0.026, 0.058},
                     {0.022, 0.060},
                     {0.022, 0.074},
                     {0.026, 0.076},
                     {0.026, 0.082},
                     {0, 0.082}},
                    40);
  return body;
}

// A cone of pleated gauze between two rings.
Mesh filter(double length) {
  return lathe({{0.027, 0},
                {0.031, 0.004},
                {0.040, 0.012},
                {0.034, length - 0.012},
                {0.034, length - 0.010}},
               120);
}

Mesh pleated(Mesh mesh) {
  for (dvec3& p : mesh.positions) {
    const double angle = std::atan2(p.z, p.x);
    const double pleat = 1 + 0.035 * std::cos(40 * angle);
    p.x *= pleat;
    p.z *= pleat;
  }
  return mesh;
}

}  // namespace

void addIntake(Model& model) {
  for (const double side : {1.0, -1.0}) {
    const dvec3 from(-0.020, 0.672, side * 0.072), towards(-1, -0.10, side * 0.10);
    const dmat4 place = pointing(from, towards);
    model.add("intake stub", "black rubber",
              transformed(cylinder(0.027, -0.012, 0.006, 0.003, 36), place));
    model.add("carburettor", "cast alloy", transformed(carburettorBody(), place));
    const dvec3 middle = from + 0.044 * glm::normalize(towards);
    model.add("float bowl", "cast alloy",
              transformed(roundedBox({0.044, 0.044, 0.046}, 0.010, 4),
                          moved(middle - dvec3(0, 0.038, 0))));
    model.add("slide cap", "black metal",
              transformed(lathe({{0.021, 0.018},
                                 {0.021, 0.032},
                                 {0.018, 0.036},
                                 {0.006, 0.040},
                                 {0.006, 0.052},
                                 {0, 0.052}},
                                36),
                          moved(middle)));
    model.add(
        "bowl screw", "brass",
        transformed(boltHead(0.014), moved(middle - dvec3(0, 0.059, 0)) * turned(180, {1, 0, 0})));
    const dmat4 behind = place * moved({0, 0.080, 0});
    model.add("air filter", "gauze", transformed(pleated(filter(0.080)), behind), 20);
    model.add("filter cap", "chrome",
              transformed(lathe({{0.037, 0.066}, {0.037, 0.078}, {0.030, 0.086}, {0, 0.088}}, 48),
                          behind));
    model.add("filter clamp", "chrome",
              transformed(ring(0.026, 0.0305, -0.002, 0.008, 0.001, 48), behind));
    model.add("throttle cable", "black rubber",
              tube(smoothPath({middle + dvec3(0, 0.05, 0),
                               middle + dvec3(0.03, 0.085, 0),
                               {0.06, 0.775, side * 0.06}},
                              10),
                   0.003, 8));
  }
}

}  // namespace glimt::assets::motorcycle
