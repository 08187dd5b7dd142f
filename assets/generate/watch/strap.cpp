#include <algorithm>
#include <cmath>
#include <numbers>

#include "assets/generate/geometry/curve.h"
#include "assets/generate/geometry/grid.h"
#include "assets/generate/geometry/hull.h"
#include "assets/generate/geometry/solids.h"
#include "assets/generate/watch/parts.h"

namespace glimt::assets::watch {
namespace {

constexpr double mm = kMillimetre;

// The cushion's section, that the strap lies on: an ellipse, rather square.
constexpr double kCushionHalfDepth = 23 * mm, kCushionHalfHeight = 19.5 * mm;
constexpr double kCushionMiddle = -26.6 * mm;
constexpr double kCushionExponent = 2.7;

// The strap's inner face from the lugs at 6 o'clock to the cushion's bottom, millimetres in y, z.
const std::vector<dvec2> kHalfLine = {{-5.9, 20.3},  {-7.0, 22.2},  {-11.5, 24.3}, {-19.5, 24.7},
                                      {-28.5, 23.9}, {-37.8, 21.1}, {-44.3, 14.5}, {-46.6, 0}};

Path innerLine() {
  Path line;
  for (const dvec2& p : kHalfLine) line.emplace_back(0, p.x * mm, p.y * mm);
  for (std::size_t i = kHalfLine.size() - 1; i-- > 0;)
    line.emplace_back(0, kHalfLine[i].x * mm, -kHalfLine[i].y * mm);
  return smoothPath(line, 16);
}

// Along the inner face: t from 0, the lugs at 6 o'clock, to 1, those at 12.
dvec3 alongStrap(double t) {
  static const Path line = innerLine();
  const double place = glm::clamp(t, 0.0, 1.0) * static_cast<double>(line.size() - 1);
  const auto before = std::min(static_cast<std::size_t>(place), line.size() - 2);
  return glm::mix(line[before], line[before + 1], place - static_cast<double>(before));
}

double halfWidthAt(double t) {
  return 0.5 * kStrapWidth * (0.985 - 0.14 * std::sin(std::numbers::pi * t));
}
double thicknessAt(double t) {
  return (2.4 + 1.9 * std::pow(std::abs(2 * t - 1), 3)) * mm;
}

dvec3 outwardAt(double t) {
  const dvec3 along = alongStrap(t + 0.01) - alongStrap(t - 0.01);
  return glm::normalize(glm::cross(along, dvec3(1, 0, 0)));
}

// A place on the strap: `side` in [-1, 1] across it, on its outer face.
dvec3 onStrap(double t, double side, double lift) {
  const dvec3 inner = alongStrap(t);
  return inner + (thicknessAt(t) + lift) * outwardAt(t) + dvec3(side * halfWidthAt(t), 0, 0);
}

// With texture coordinates in tiles of 8 mm.
Mesh strapBody() {
  constexpr int kAround = 48, kAlong = 150;
  constexpr double kTile = 8 * mm, kLength = 150 * mm;
  const auto section = superellipse(1, 0.5, 5, kAround);
  return texturedGrid(
      kAround, kAlong, dvec2(2 * (kStrapWidth + 3 * mm), kLength) / kTile, [&](int i, int j) {
        const double t = static_cast<double>(j) / kAlong;
        const dvec2 p = section[i % kAround];
        // Padded: higher in the middle.
        const double padding = p.y > 0 ? 0.22 * (1 - p.x * p.x) : 0;
        const double height = thicknessAt(t) * (p.y + 0.5 + padding);
        return alongStrap(t) + height * outwardAt(t) + dvec3(p.x * halfWidthAt(t), 0, 0);
      });
}

Mesh stitches() {
  constexpr int kCount = 46;
  Mesh all;
  for (const double side : {-0.80, 0.80})
    for (int k = 1; k < kCount; ++k) {
      const double t = static_cast<double>(k) / kCount, half = 0.32 / kCount;
      append(all,
             tube(smoothPath({onStrap(t - half, side, -0.35 * mm),
                              onStrap(t - 0.8 * half, side, 0.12 * mm), onStrap(t, side, 0.26 * mm),
                              onStrap(t + 0.8 * half, side, 0.12 * mm),
                              onStrap(t + half, side, -0.35 * mm)},
                             3),
                  0.26 * mm, 10));
    }
  return all;
}

}  // namespace

void addStrap(Model& model) {
  model.add("strap", "strap", strapBody(), 60);
  model.add("stitches", "stitches", stitches());
}

void addCushion(Model& model) {
  const double y = kCushionMiddle, h = kCushionHalfHeight, d = kCushionHalfDepth;
  const Hull hull({{-40 * mm, 0.90 * d, y + 0.90 * h, y - 0.90 * h, kCushionExponent},
                   {-20 * mm, d, y + h, y - h, kCushionExponent},
                   {20 * mm, d, y + h, y - h, kCushionExponent},
                   {40 * mm, 0.90 * d, y + 0.90 * h, y - 0.90 * h, kCushionExponent}},
                  5);
  model.add("cushion", "cushion", hull.mesh(72, 120), 60);
  Path seam;
  for (int k = 0; k < 160; ++k) seam.push_back(hull.at(0.955, 360.0 * k / 160));
  model.add("cushion piping", "cushion", closedTube(seam, 0.7 * mm, 12));
  for (dvec3& p : seam) p.x = -p.x;
  model.add("cushion piping", "cushion", closedTube(seam, 0.7 * mm, 12));
}

}  // namespace glimt::assets::watch
