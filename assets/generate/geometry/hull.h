// Long rounded bodies along x: a tank, a seat, a cowl.
#pragma once

#include <functional>
#include <vector>

#include "assets/generate/geometry/mesh.h"

namespace glimt::assets {

// A cross-section: a superellipse between two heights.
struct HullSection {
  double x;
  double half_width;
  double top, bottom;
  double exponent;  // 2: an ellipse; larger: squarer
};

// The surface through sections from the smallest x to the largest, closed by rounded ends.
class Hull {
 public:
  // `end_exponent` of the ends' outline: 2 is an ellipse over the whole length, 8 nearly flat ends.
  // `dent` moves points of the surface, for what an ellipse cannot do; may be empty.
  Hull(std::vector<HullSection> sections, double end_exponent,
       std::function<dvec3(const dvec3&)> dent = {});

  // `along` from 0 (smallest x) to 1; `around` in degrees: 0 is the top, 90 the side of +z.
  dvec3 at(double along, double around) const;
  dvec3 normal(double along, double around) const;

  Mesh mesh(int steps_along, int steps_around) const;

  // A piece of the surface, lifted by `lift`, between two lines that are given as `around`.
  Mesh band(double from, double to, const std::function<double(double)>& low,
            const std::function<double(double)>& high, double lift, int steps_along,
            int steps_around) const;

 private:
  HullSection sectionAt(double along) const;

  std::vector<HullSection> sections_;
  double end_exponent_;
  std::function<dvec3(const dvec3&)> dent_;
};

}  // namespace glimt::assets
