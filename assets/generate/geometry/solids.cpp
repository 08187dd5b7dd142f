#include "assets/generate/geometry/solids.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "assets/generate/geometry/grid.h"

namespace glimt::assets {
namespace {

constexpr double kPi = std::numbers::pi;

dvec3 onLathe(const dvec2& point, double angle) {
  return {point.x * std::cos(angle), point.y, -point.x * std::sin(angle)};
}

// Coordinates along one axis: `segments` over each rounded edge, one flat piece between.
std::vector<double> roundedSteps(double flat_half, double radius, int segments) {
  std::vector<double> steps;
  for (int k = -segments; k <= 0; ++k)
    steps.push_back(-flat_half + radius * std::tan(0.25 * kPi * k / segments));
  for (int k = flat_half > 0 ? 0 : 1; k <= segments; ++k)
    steps.push_back(flat_half + radius * std::tan(0.25 * kPi * k / segments));
  return steps;
}

// The outline moved inwards: along the middle of the two edges at each corner.
std::vector<dvec2> inset(const std::vector<dvec2>& outline, double by) {
  std::vector<dvec2> moved_in;
  const std::size_t count = outline.size();
  for (std::size_t i = 0; i < count; ++i) {
    const dvec2 before = glm::normalize(outline[i] - outline[(i + count - 1) % count]);
    const dvec2 after = glm::normalize(outline[(i + 1) % count] - outline[i]);
    const dvec2 in_before(-before.y, before.x), in_after(-after.y, after.x);
    const dvec2 middle = glm::normalize(in_before + in_after);
    moved_in.push_back(outline[i] + middle * (by / std::max(0.3, glm::dot(middle, in_after))));
  }
  return moved_in;
}

}  // namespace

Mesh lathe(const std::vector<dvec2>& profile, int segments) {
  return grid(segments, static_cast<int>(profile.size()) - 1, Edges::closed, Edges::open,
              [&](int i, int j) { return onLathe(profile[j], 2 * kPi * i / segments); });
}

Mesh cylinder(double radius, double bottom, double top, double bevel, int segments) {
  return lathe({{0, bottom},
                {radius - bevel, bottom},
                {radius - 0.3 * bevel, bottom + 0.3 * bevel},
                {radius, bottom + bevel},
                {radius, top - bevel},
                {radius - 0.3 * bevel, top - 0.3 * bevel},
                {radius - bevel, top},
                {0, top}},
               segments);
}

Mesh ring(double inner, double outer, double bottom, double top, double bevel, int segments) {
  const std::vector<dvec2> profile{
      {inner, bottom + bevel}, {inner + bevel, bottom}, {outer - bevel, bottom},
      {outer, bottom + bevel}, {outer, top - bevel},    {outer - bevel, top},
      {inner + bevel, top},    {inner, top - bevel},    {inner, bottom + bevel}};
  return lathe(profile, segments);
}

Mesh torus(double radius, double tube, int segments, int sides) {
  return grid(segments, sides, Edges::closed, Edges::closed, [&](int i, int j) {
    const double a = 2 * kPi * j / sides;
    return onLathe({radius + tube * std::cos(a), tube * std::sin(a)}, 2 * kPi * i / segments);
  });
}

Mesh sphere(double radius, int segments) {
  std::vector<dvec2> profile;
  const int rows = segments / 2;
  for (int j = 0; j <= rows; ++j) {
    const double angle = kPi * j / rows;
    profile.emplace_back(j % rows == 0 ? 0 : radius * std::sin(angle), -radius * std::cos(angle));
  }
  return lathe(profile, segments);
}

Mesh roundedBox(const dvec3& size, double radius, int segments) {
  Mesh mesh;
  const dvec3 flat_half = glm::max(0.5 * size - radius, dvec3(0));
  for (int face = 0; face < 6; ++face) {
    const int axis = face % 3, u_axis = (axis + 1) % 3, v_axis = (axis + 2) % 3;
    const double side = face < 3 ? 1 : -1;
    const auto u = roundedSteps(flat_half[u_axis], radius, segments);
    const auto v = roundedSteps(flat_half[v_axis], radius, segments);
    append(mesh, grid(static_cast<int>(u.size()) - 1, static_cast<int>(v.size()) - 1, Edges::open,
                      Edges::open, [&](int i, int j) {
                        dvec3 on_box;
                        on_box[axis] = side * 0.5 * size[axis];
                        on_box[u_axis] = side * u[i];  // keeps the far face's winding outward
                        on_box[v_axis] = v[j];
                        const dvec3 core = glm::clamp(on_box, -flat_half, flat_half);
                        return core + radius * glm::normalize(on_box - core);
                      }));
  }
  return mesh;
}

Mesh plate(const std::vector<dvec2>& outline, double depth, double bevel) {
  const std::vector<dvec2> inner = inset(outline, bevel);
  std::vector<std::vector<dvec3>> rings(4);
  for (std::size_t i = 0; i < outline.size(); ++i) {
    rings[0].emplace_back(inner[i], 0);
    rings[1].emplace_back(outline[i], bevel);
    rings[2].emplace_back(outline[i], depth - bevel);
    rings[3].emplace_back(inner[i], depth);
  }
  return loft(rings, true);
}

Mesh cover(const std::vector<dvec2>& outline, double depth, double radius, int steps) {
  std::vector<std::vector<dvec3>> rings(1);
  for (const dvec2& point : outline) rings[0].emplace_back(point, 0);
  for (int k = 0; k <= steps; ++k) {
    const double angle = 0.5 * kPi * k / steps;
    const double height = depth - radius + radius * std::sin(angle);
    std::vector<dvec3>& ring = rings.emplace_back();
    for (const dvec2& point : inset(outline, radius * (1 - std::cos(angle))))
      ring.emplace_back(point, height);
  }
  return loft(rings, true);
}

std::vector<dvec2> beltOutline(const dvec2& a, double radius_a, const dvec2& b, double radius_b,
                               int steps) {
  const dvec2 apart = b - a;
  const double lean = std::acos((radius_a - radius_b) / glm::length(apart));
  const double ahead = std::atan2(apart.y, apart.x);
  std::vector<dvec2> outline;
  const auto arc = [&](const dvec2& center, double radius, double from, double to) {
    for (int k = 0; k <= steps; ++k) {
      const double angle = glm::mix(from, to, static_cast<double>(k) / steps);
      outline.push_back(center + radius * dvec2(std::cos(angle), std::sin(angle)));
    }
  };
  arc(b, radius_b, ahead - lean, ahead + lean);
  arc(a, radius_a, ahead + lean, ahead + 2 * kPi - lean);
  return outline;
}

Mesh boltHead(double size) {
  const double r = 0.5 * size;
  return lathe({{r, 0}, {r, 0.5 * size}, {0.86 * r, 0.58 * size}, {0, 0.58 * size}}, 6);
}

}  // namespace glimt::assets
