#include "renderer/scene/polygon.h"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <limits>
#include <numbers>

using namespace glimt;

namespace {

std::vector<std::array<std::uint32_t, 3>> cut(const std::vector<Vec3>& points) {
  std::int64_t effort = kEffortForPolygon;
  return triangulate(points, effort);
}

// The sum of the triangles' areas; negative for those that face against `facing`.
double areaOf(const std::vector<Vec3>& points, const Vec3& facing) {
  double area = 0;
  for (const auto& [a, b, c] : cut(points)) {
    const glm::dvec3 p(points[a]);
    const glm::dvec3 normal = glm::cross(glm::dvec3(points[b]) - p, glm::dvec3(points[c]) - p);
    const double size = 0.5 * glm::length(normal);
    CHECK(glm::dot(normal, glm::dvec3(facing)) >= 0);
    area += size;
  }
  return area;
}

std::vector<Vec3> ring(std::size_t corners, float even_radius, float odd_radius) {
  std::vector<Vec3> points;
  for (std::size_t i = 0; i < corners; ++i) {
    const double angle =
        2 * std::numbers::pi * static_cast<double>(i) / static_cast<double>(corners);
    const double radius = i % 2 == 0 ? even_radius : odd_radius;
    points.emplace_back(100 + radius * std::cos(angle), 7, -30 - radius * std::sin(angle));
  }
  return points;
}

}  // namespace

TEST_CASE("polygons of less than three corners have no triangles") {
  CHECK(cut({}).empty());
  CHECK(cut({Vec3(0), Vec3(1)}).empty());
}

TEST_CASE("a convex quadrangle is cut along its shorter diagonal") {
  const std::vector<Vec3> kite = {{0, 0, 0}, {1, -3, 0}, {2, 0, 0}, {1, 3, 0}};
  CHECK(cut(kite) == std::vector<std::array<std::uint32_t, 3>>{{0, 1, 2}, {0, 2, 3}});
}

TEST_CASE("a concave quadrangle is covered exactly, whichever corner it begins with") {
  std::vector<Vec3> dart = {{0, 0, 0}, {4, 1, 0}, {0, 2, 0}, {1, 1, 0}};
  for (int turn = 0; turn < 4; ++turn) {
    CHECK(areaOf(dart, {0, 0, 1}) == Approx(3));
    std::rotate(dart.begin(), dart.begin() + 1, dart.end());
  }
}

TEST_CASE("convex and star-shaped polygons away from the origin are covered exactly") {
  const double n = 40;
  CHECK(areaOf(ring(40, 2, 2), {0, 1, 0}) ==
        Approx(0.5 * n * 4 * std::sin(2 * std::numbers::pi / n)).epsilon(1e-4));
  CHECK(areaOf(ring(40, 3, 1), {0, 1, 0}) ==
        Approx(0.5 * n * 3 * std::sin(2 * std::numbers::pi / n)).epsilon(1e-4));
}

TEST_CASE("a polygon with a hole, cut open along a bridge, leaves the hole open") {
  const std::vector<Vec3> points = {{0, 0, 0}, {4, 0, 0}, {4, 4, 0}, {0, 4, 0}, {0, 0, 0},
                                    {1, 1, 0}, {1, 3, 0}, {3, 3, 0}, {3, 1, 0}, {1, 1, 0}};
  CHECK(areaOf(points, {0, 0, 1}) == Approx(12));
}

TEST_CASE("any polygon of n corners gives n - 2 triangles: lines, crossings, what is not finite") {
  const float nan = std::nanf("");
  const float infinity = std::numeric_limits<float>::infinity();
  const std::vector<std::vector<Vec3>> polygons = {
      {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {3, 0, 0}, {4, 0, 0}},
      std::vector<Vec3>(6, Vec3(1)),
      {{0, 0, 0}, {1, 1, 0}, {1, 0, 0}, {0, 1, 0}},
      {{0, 0, 0}, {2, 2, 0}, {2, 0, 0}, {0, 2, 0}, {1, 5, 0}},
      {{nan, 0, 0}, {1, nan, 0}, {1, 1, 0}, {0, 1, nan}, {0, 0, 1}},
      {{0, 0, 0}, {infinity, 0, 0}, {1, -infinity, 0}, {0, 1, 0}, {0, 2, 2}},
      {{0, 0, 0}, {3e38f, 0, 0}, {3e38f, 3e38f, 0}, {0, -3e38f, 0}, {-3e38f, 2, 2}}};
  for (const std::vector<Vec3>& points : polygons) {
    CHECK(cut(points).size() == points.size() - 2);
  }
}

TEST_CASE("a polygon of very many corners takes no unreasonable time") {
  const std::size_t n = 100'000;
  CHECK(cut(ring(n, 2, 2)).size() == n - 2);
  CHECK(cut(ring(n, 2, 1)).size() == n - 2);
  CHECK(cut(std::vector<Vec3>(n, Vec3(std::nanf("")))).size() == n - 2);
}

TEST_CASE("polygons that are not convex share an effort, and are still cut when it is used up") {
  const std::vector<Vec3> star = ring(4000, 2, 1);
  std::int64_t effort = 3 * kEffortForPolygon / 2;
  for (const std::int64_t left : {kEffortForPolygon / 2, std::int64_t{0}, std::int64_t{0}}) {
    CHECK(triangulate(star, effort).size() == star.size() - 2);
    CHECK(effort >= left);
  }
  effort = 0;
  CHECK(triangulate(star, effort).size() == star.size() - 2);
  CHECK(effort == 0);
}
