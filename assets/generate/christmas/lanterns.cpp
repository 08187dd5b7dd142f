#include "assets/generate/christmas/parts.h"
#include "assets/generate/geometry/solids.h"

namespace glimt::assets::christmas {
namespace {

// A lantern of black iron with a candle; `height` without the handle.
void addLantern(Model& model, const dvec3& at, double width, double height, double turn) {
  const dmat4 place = moved(at) * turned(turn, {0, 1, 0});
  const double half = 0.5 * width, bar = 0.012;
  Mesh iron =
      transformed(roundedBox({width + 0.03, 0.022, width + 0.03}, 0.004, 2), moved({0, 0.011, 0}));
  append(iron, transformed(roundedBox({width + 0.03, 0.018, width + 0.03}, 0.004, 2),
                           moved({0, height, 0})));
  for (const double x : {-half, half})
    for (const double z : {-half, half})
      append(iron,
             transformed(roundedBox({bar, height, bar}, 0.002, 2), moved({x, 0.5 * height, z})));
  // A roof of four slopes: a lathe of four sides.
  append(iron, transformed(lathe({{0.76 * width, 0},
                                  {0.72 * width, 0.012},
                                  {0.20 * width, 0.30 * width},
                                  {0.18 * width, 0.42 * width},
                                  {0, 0.44 * width}},
                                 4),
                           moved({0, height + 0.008, 0}) * turned(45, {0, 1, 0})));
  append(iron, transformed(torus(0.20 * width, 0.004, 32, 8),
                           moved({0, height + 0.62 * width, 0}) * turned(90, {1, 0, 0})));
  model.add("lantern", "iron", transformed(iron, place));
  const double wax = 0.42 * height, r = 0.22 * width;
  model.add("candle", "wax",
            transformed(lathe({{r, 0.022},
                               {r, wax},
                               {0.93 * r, wax + 0.006},
                               {0.80 * r, wax + 0.002},
                               {0.4 * r, wax - 0.010},
                               {0, wax - 0.012}},
                              40),
                        place));
  model.add("wick", "iron",
            transformed(tube({{0, wax - 0.012, 0}, {0.002, wax + 0.012, 0}}, 0.0012, 6), place));
  model.add("flame", "flame",
            transformed(lathe({{0, wax + 0.006},
                               {0.0055, wax + 0.012},
                               {0.0085, wax + 0.022},
                               {0.0068, wax + 0.036},
                               {0.0030, wax + 0.052},
                               {0, wax + 0.066}},
                              12),
                        place),
            60);
}

}  // namespace

void addLanterns(Model& model) {
  addLantern(model, {-1.18, 0, 0.18}, 0.17, 0.36, 20);
  addLantern(model, {-0.96, 0, 0.46}, 0.12, 0.23, -15);
}

}  // namespace glimt::assets::christmas
