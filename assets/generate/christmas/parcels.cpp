#include <cmath>

#include "assets/generate/christmas/parts.h"
#include "assets/generate/geometry/grid.h"
#include "assets/generate/geometry/solids.h"

namespace glimt::assets::christmas {
namespace {

struct Parcel {
  dvec3 size;
  dvec2 at;  // x, z on the floor
  double turn;
  double above;  // of the floor
  const char* paper;
  const char* ribbon;
};

const Parcel kParcels[] = {
    {{0.40, 0.26, 0.30}, {-0.36, 0.36}, 18, 0, "red paper", "gold ribbon"},
    {{0.27, 0.19, 0.24}, {-0.33, 0.34}, -12, 0.26, "cream paper", "red ribbon"},
    {{0.30, 0.34, 0.28}, {0.70, 0.18}, -22, 0, "green paper", "red ribbon"},
    {{0.34, 0.15, 0.25}, {0.34, 0.62}, 12, 0, "kraft paper", "green ribbon"},
    {{0.16, 0.14, 0.16}, {0.66, 0.66}, 38, 0, "navy paper", "silver ribbon"},
    {{0.19, 0.17, 0.19}, {-0.70, 0.72}, 30, 0, "navy paper", "gold ribbon"},
    {{0.22, 0.11, 0.17}, {-0.02, 0.70}, -28, 0, "red paper", "silver ribbon"},
    {{0.24, 0.40, 0.24}, {1.05, -0.20}, 8, 0, "cream paper", "gold ribbon"},
};

// A flat band, `width` wide, along a path; the path's first step lies across `up`.
Mesh ribbonAlong(const Path& path, double width, const dvec3& up) {
  return sweep(
      path,
      {{-0.5 * width, -0.0006},
       {0.5 * width, -0.0006},
       {0.5 * width, 0.0006},
       {-0.5 * width, 0.0006}},
      up, [](double) { return 1.0; }, true);
}

// A loop of a bow that stands out towards +x.
Mesh bowLoop(double size, double width) {
  const Path loop = smoothPath({{0, 0, 0},
                                {0.45 * size, 0.30 * size, 0},
                                {0.92 * size, 0.50 * size, 0},
                                {1.12 * size, 0.26 * size, 0},
                                {0.80 * size, 0.05 * size, 0},
                                {0.35 * size, 0.02 * size, 0},
                                {0, 0.01 * size, 0}},
                               8);
  return ribbonAlong(loop, width, {0, 1, 0});
}

Mesh bow(double size, double width) {
  Mesh all;
  for (const double turn : {20.0, 160.0, 200.0, 340.0, 90.0, 270.0})
    append(all, transformed(bowLoop(turn == 90 || turn == 270 ? 0.8 * size : size, width),
                            turned(turn, {0, 1, 0})));
  append(all, transformed(roundedBox({0.42 * size, 0.34 * size, 0.42 * size}, 0.14 * size, 4),
                          moved({0, 0.12 * size, 0})));
  for (const double turn : {60.0, -115.0}) {
    const Path end = smoothPath({{0, 0.004, 0},
                                 {0.6 * size, 0.06 * size, 0},
                                 {1.3 * size, 0.02 * size, 0.1 * size},
                                 {1.7 * size, 0.05 * size, 0.2 * size}},
                                8);
    append(all, transformed(ribbonAlong(end, width, {0, 1, 0}), turned(turn, {0, 1, 0})));
  }
  return all;
}

void addParcel(Model& model, const Parcel& parcel) {
  const dmat4 place = treePlace() * moved({parcel.at.x, parcel.above, parcel.at.y}) *
                      turned(parcel.turn, {0, 1, 0});
  const dvec3 s = parcel.size;
  const double width = 0.028, lift = 0.003;
  const dmat4 middle = place * moved({0, 0.5 * s.y, 0});
  model.add("parcel", parcel.paper, transformed(roundedBox(s, 0.004, 3), middle));
  Mesh bands = roundedBox({s.x + lift, s.y + lift, width}, 0.0012, 2);
  append(bands, roundedBox({width, s.y + 1.2 * lift, s.z + lift}, 0.0012, 2));
  model.add("ribbon", parcel.ribbon, transformed(bands, middle));
  const double size = 0.36 * std::min(s.x, s.z);
  model.add(
      "bow", parcel.ribbon,
      transformed(bow(size, width), place * moved({0, s.y + 0.002, 0}) * turned(33, {0, 1, 0})),
      50);
}

}  // namespace

void addParcels(Model& model) {
  for (const Parcel& parcel : kParcels) addParcel(model, parcel);
}

}  // namespace glimt::assets::christmas
