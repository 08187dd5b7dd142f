#include "assets/generate/geometry/hull.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "assets/generate/geometry/grid.h"

namespace glimt::assets {
namespace {

double hermite(double a, double b, double c, double d, double t) {
  return b + 0.5 * t * (c - a + t * (2 * a - 5 * b + 4 * c - d + t * (3 * (b - c) + d - a)));
}

}  // namespace

Hull::Hull(std::vector<HullSection> sections, double end_exponent,
           std::function<dvec3(const dvec3&)> dent)
    : sections_(std::move(sections)), end_exponent_(end_exponent), dent_(std::move(dent)) {}

HullSection Hull::sectionAt(double along) const {
  const int last = static_cast<int>(sections_.size()) - 1;
  const double x = glm::mix(sections_.front().x, sections_.back().x, along);
  int i = 0;
  while (i < last - 1 && sections_[i + 1].x < x) ++i;
  const double t = (x - sections_[i].x) / (sections_[i + 1].x - sections_[i].x);
  const HullSection &a = sections_[std::max(i - 1, 0)], &b = sections_[i], &c = sections_[i + 1],
                    &d = sections_[std::min(i + 2, last)];
  const auto between = [&](double HullSection::*field) {
    return hermite(a.*field, b.*field, c.*field, d.*field, t);
  };
  return {x, between(&HullSection::half_width), between(&HullSection::top),
          between(&HullSection::bottom), between(&HullSection::exponent)};
}

dvec3 Hull::at(double along, double around) const {
  const HullSection section = sectionAt(along);
  const double from_middle = std::min(1.0, std::abs(2 * along - 1));
  const double end = std::pow(1 - std::pow(from_middle, end_exponent_), 1 / end_exponent_);
  const double c = std::cos(glm::radians(around)), s = std::sin(glm::radians(around));
  const double n = section.exponent;
  const double outward =
      end * std::pow(std::pow(std::abs(c), n) + std::pow(std::abs(s), n), -1 / n);
  const double middle = 0.5 * (section.top + section.bottom);
  const double half_height = 0.5 * (section.top - section.bottom);
  const dvec3 point(section.x, middle + half_height * outward * c,
                    section.half_width * outward * s);
  return dent_ ? dent_(point) : point;
}

dvec3 Hull::normal(double along, double around) const {
  constexpr double kStep = 1e-4;
  const double a = std::clamp(along, 2 * kStep, 1 - 2 * kStep);
  const dvec3 by_x = at(a + kStep, around) - at(a - kStep, around);
  const dvec3 by_angle = at(a, around + 0.05) - at(a, around - 0.05);
  return glm::normalize(glm::cross(by_angle, by_x));
}

Mesh Hull::mesh(int steps_along, int steps_around) const {
  return grid(steps_around, steps_along, Edges::closed, Edges::open, [&](int i, int j) {
    // Denser where the ends turn in.
    const double along = 0.5 - 0.5 * std::cos(std::numbers::pi * j / steps_along);
    return at(along, 360.0 * i / steps_around);
  });
}

Mesh Hull::band(double from, double to, const std::function<double(double)>& low,
                const std::function<double(double)>& high, double lift, int steps_along,
                int steps_around) const {
  return grid(steps_around, steps_along, Edges::open, Edges::open, [&](int i, int j) {
    const double along = glm::mix(from, to, static_cast<double>(j) / steps_along);
    const double around = glm::mix(low(along), high(along), static_cast<double>(i) / steps_around);
    return at(along, around) + lift * normal(along, around);
  });
}

}  // namespace glimt::assets
