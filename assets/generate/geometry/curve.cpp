#include "assets/generate/geometry/curve.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "assets/generate/geometry/grid.h"

namespace glimt::assets {
namespace {

constexpr double kPi = std::numbers::pi;

dvec3 catmullRom(const dvec3& a, const dvec3& b, const dvec3& c, const dvec3& d, double t) {
  return 0.5 * (2.0 * b + (c - a) * t + (2.0 * a - 5.0 * b + 4.0 * c - d) * t * t +
                (3.0 * b - a - 3.0 * c + d) * t * t * t);
}

dvec3 tangentAt(const Path& path, std::size_t i) {
  const std::size_t before = i == 0 ? 0 : i - 1, after = std::min(i + 1, path.size() - 1);
  return glm::normalize(path[after] - path[before]);
}

std::vector<dvec3> placed(const std::vector<dvec2>& section, const dvec3& at, const dvec3& side,
                          const dvec3& up, double scale) {
  std::vector<dvec3> ring;
  for (const dvec2& p : section) ring.push_back(at + scale * (p.x * side + p.y * up));
  return ring;
}

}  // namespace

Path smoothPath(const Path& controls, int steps) {
  Path path;
  const int last = static_cast<int>(controls.size()) - 1;
  const auto control = [&](int i) {
    if (i < 0) return 2.0 * controls[0] - controls[1];
    if (i > last) return 2.0 * controls[last] - controls[last - 1];
    return controls[i];
  };
  for (int i = 0; i < last; ++i)
    for (int k = 0; k < steps; ++k)
      path.push_back(catmullRom(control(i - 1), control(i), control(i + 1), control(i + 2),
                                static_cast<double>(k) / steps));
  path.push_back(controls.back());
  return path;
}

Path bentPath(const Path& controls, double radius, int steps) {
  Path path{controls.front()};
  for (std::size_t i = 1; i + 1 < controls.size(); ++i) {
    const dvec3 corner = controls[i];
    const dvec3 in = glm::normalize(corner - controls[i - 1]);
    const dvec3 out = glm::normalize(controls[i + 1] - corner);
    const double turn = std::acos(std::clamp(glm::dot(in, out), -1.0, 1.0));
    if (turn < 1e-3) {
      path.push_back(corner);
      continue;
    }
    const double shortest =
        std::min(glm::length(corner - controls[i - 1]), glm::length(controls[i + 1] - corner));
    const double cut = std::min(radius * std::tan(0.5 * turn), 0.49 * shortest);
    const double bend = cut / std::tan(0.5 * turn);
    const dvec3 inward = glm::normalize(out - in);
    const dvec3 center = corner + inward * (bend / std::cos(0.5 * turn));
    const dvec3 start = glm::normalize(corner - in * cut - center);
    for (int k = 0; k <= steps; ++k) {
      const double angle = turn * k / steps;
      path.push_back(center + bend * (std::cos(angle) * start + std::sin(angle) * in));
    }
  }
  path.push_back(controls.back());
  return path;
}

Path arcPath(const dvec3& center, const dvec3& x, const dvec3& y, double from_degrees,
             double to_degrees, int steps) {
  Path path;
  for (int k = 0; k <= steps; ++k) {
    const double angle = glm::radians(from_degrees + (to_degrees - from_degrees) * k / steps);
    path.push_back(center + std::cos(angle) * x + std::sin(angle) * y);
  }
  return path;
}

Mesh sweep(const Path& path, const std::vector<dvec2>& section, const dvec3& up,
           const std::function<double(double)>& scale, bool capped) {
  std::vector<std::vector<dvec3>> rings;
  dvec3 above = up;
  for (std::size_t i = 0; i < path.size(); ++i) {
    const dvec3 along = tangentAt(path, i);
    above = glm::normalize(above - along * glm::dot(above, along));
    const double t = static_cast<double>(i) / static_cast<double>(path.size() - 1);
    rings.push_back(placed(section, path[i], glm::cross(above, along), above, scale(t)));
  }
  return loft(rings, capped);
}

Mesh tube(const Path& path, double radius, int sides) {
  const dvec3 along = tangentAt(path, 0);
  const dvec3 up = std::abs(along.y) < 0.9 ? dvec3(0, 1, 0) : dvec3(1, 0, 0);
  return sweep(
      path, circle(radius, sides), up, [](double) { return 1.0; }, true);
}

Mesh closedTube(const Path& path, double radius, int sides) {
  const int count = static_cast<int>(path.size());
  const auto section = circle(radius, sides);
  std::vector<std::vector<dvec3>> rings;
  dvec3 above(0, 1, 0);
  for (int i = 0; i < count; ++i) {
    const dvec3 along = glm::normalize(path[(i + 1) % count] - path[(i + count - 1) % count]);
    if (i == 0 && std::abs(along.y) > 0.9) above = dvec3(1, 0, 0);
    above = glm::normalize(above - along * glm::dot(above, along));
    rings.push_back(placed(section, path[i], glm::cross(above, along), above, 1));
  }
  return grid(sides, count, Edges::closed, Edges::closed,
              [&](int i, int j) { return rings[j][i]; });
}

Mesh coilSpring(double radius, double wire, double height, double turns, int steps_per_turn) {
  Path path;
  const int steps = static_cast<int>(turns * steps_per_turn);
  for (int k = 0; k <= steps; ++k) {
    const double angle = 2 * kPi * k / steps_per_turn;
    path.emplace_back(radius * std::cos(angle), height * k / steps, -radius * std::sin(angle));
  }
  return tube(path, wire, 8);
}

std::vector<dvec2> circle(double radius, int sides) {
  return superellipse(radius, radius, 2, sides);
}

std::vector<dvec2> superellipse(double a, double b, double exponent, int sides) {
  std::vector<dvec2> points;
  for (int i = 0; i < sides; ++i) {
    const double angle = 2 * kPi * i / sides;
    const double x = std::cos(angle), y = std::sin(angle);
    const double outward =
        std::pow(std::pow(std::abs(x), exponent) + std::pow(std::abs(y), exponent), -1 / exponent);
    points.emplace_back(a * outward * x, b * outward * y);
  }
  return points;
}

}  // namespace glimt::assets
