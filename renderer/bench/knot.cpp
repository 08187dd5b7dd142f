#include "renderer/bench/knot.h"

#include <cmath>
#include <numbers>

namespace glimt {
namespace {

glm::dvec3 knotCurve(double s) {
  const double radius = 2 + std::cos(3 * s);
  return {radius * std::cos(2 * s), radius * std::sin(2 * s), std::sin(3 * s)};
}

// A point of the tube: `s` goes along the knot and `angle` around it.
Vec3 tubePoint(double s, double angle) {
  const glm::dvec3 center = knotCurve(s);
  const glm::dvec3 along = glm::normalize(knotCurve(s + 1e-4) - knotCurve(s - 1e-4));
  const glm::dvec3 across = glm::normalize(glm::cross(along, center));
  const glm::dvec3 up = glm::cross(across, along);
  const double radius = 0.35 + 0.08 * std::sin(20 * s + 3 * angle);
  return Vec3(center + radius * (std::cos(angle) * across + std::sin(angle) * up));
}

}  // namespace

void addQuad(Scene& scene, const std::array<std::uint32_t, 4>& corners, std::uint32_t material) {
  const auto [a, b, c, d] = corners;
  Triangle triangle;
  triangle.material = material;
  triangle.positions = {a, b, c};
  scene.triangles.push_back(triangle);
  triangle.positions = {a, c, d};
  scene.triangles.push_back(triangle);
}

void addKnot(Scene& scene, const KnotSize& size) {
  const auto index = [&](std::uint32_t ring, std::uint32_t side) {
    return ring % size.rings * size.sides + side % size.sides;
  };
  constexpr double kTurn = 2 * std::numbers::pi;
  for (std::uint32_t ring = 0; ring < size.rings; ++ring)
    for (std::uint32_t side = 0; side < size.sides; ++side) {
      scene.positions.push_back(tubePoint(kTurn * ring / size.rings, kTurn * side / size.sides));
      addQuad(scene, {index(ring, side), index(ring + 1, side), index(ring + 1, side + 1),
                      index(ring, side + 1)});
    }
}

}  // namespace glimt
