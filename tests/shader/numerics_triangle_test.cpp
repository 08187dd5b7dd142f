// Intersection and ray origins in float against double: rows of docs/numerics.md.
//
// The bounds, to the first order. u: one rounding, 2^-24. d: the direction, unit. L: the longest
// edge. D = t + L: no corner is further from the origin. N: the normal, as long as the double area.
// c = |d . N| / L^2.
//
// t = (a . N) / (d . N). An error in N changes t by (a - t d) . error / (d . N), and a - t d lies
// in the triangle, so its lever is L. N's own is 4 D L u from the corners' subtractions and 4.83
// L^2 u from edges and cross product: together 8.83. The numerator's roundings are 4 D L^2 u, the
// denominator's 3 t L^2 u, the quotient's t u.
//
// A volume is twice d . (from x to), linear in each corner with a lever of 2 L: 4 D L u from the
// corners' subtractions, 2 L^2 u and 2 D L u from difference and sum, 5.66 D L u from the cross
// product, 6 D L u from the dot product, together 19.7. A weight is a volume over the sum of three,
// which is 2 c L^2: (1 + 3) * 19.7 / 2, and 3 u for sum and quotient.
//
// A point: u times the largest coordinate for each of three roundings of three coordinates, and
// once more for adding the step.
#include <algorithm>
#include <cmath>

#include "tests/shader/error_row.h"
#include "tests/shader/glsl_double.h"
#include "tests/shader/glsl_float.h"
#include "tests/shader/random.h"

using namespace glimt;
using test::ErrorStatistics;
using test::kRounding;

namespace {

struct Corners {
  glm::vec3 v0, v1, v2;

  double longestEdge() const {
    const glm::dvec3 a(v0), b(v1), c(v2);
    return std::max({glm::length(b - a), glm::length(c - a), glm::length(c - b)});
  }
  glm::dvec3 normal() const {
    return glm::cross(glm::dvec3(v1) - glm::dvec3(v0), glm::dvec3(v2) - glm::dvec3(v0));
  }
};

// Of sizes and places over many orders of magnitude, one in two a sliver.
Corners randomCorners(test::Random& random, float thinnest, float farthest) {
  const float size = random.logUniform(1e-2f, 1e2f);
  const float thin = random.below(2) ? random.logUniform(thinnest, 1) : 1.0f;
  const glm::vec3 place =
      random.below(4) ? size * random.logUniform(1e-2f, farthest) * random.cube() : glm::vec3(0);
  const glm::vec3 a = size * random.direction();
  const glm::vec3 b = size * random.direction();
  return {place, place + a, place + random.uniform() * a + thin * b};
}

// A point of the triangle, in one of four cases on its rim.
glm::vec2 aim(test::Random& random) {
  const glm::vec2 uv = random.weights();
  if (random.below(4)) return uv;
  return random.below(2) ? glm::vec2(uv.x, 0) : glm::vec2(uv.x, 1 - uv.x);
}

void measureIntersection(int count) {
  test::Random random(60);
  ErrorStatistics distances, weights;
  while (distances.count() < static_cast<std::uint64_t>(count)) {
    const Corners c = randomCorners(random, 1e-3f, 1e2f);
    const double edge = c.longestEdge();
    const glm::vec3 direction = random.direction();
    const glm::vec3 target = glsl_float::interpolate(c.v0, c.v1, c.v2, aim(random));
    const glm::vec3 origin = target - float(edge) * random.logUniform(1e-2f, 1e3f) * direction;
    const auto is =
        glsl_float::intersectTriangle(origin, direction, c.v0, c.v1, c.v2, glsl_float::FAR_AWAY);
    const auto exact =
        glsl_double::intersectTriangle(glm::dvec3(origin), glm::dvec3(direction), glm::dvec3(c.v0),
                                       glm::dvec3(c.v1), glm::dvec3(c.v2), glsl_double::FAR_AWAY);
    if (is.t < 0 || exact.t < 0) continue;
    // Double area across the ray, in squares of the longest edge.
    const double condition = std::abs(glm::dot(c.normal(), glm::dvec3(direction))) / (edge * edge);
    const double reach = exact.t + edge;
    if (!(60 * kRounding * reach < 0.02 * edge * condition)) continue;
    distances.add(std::abs(is.t - exact.t) / (reach / condition) / kRounding);
    const glm::dvec2 off = glm::abs(glm::dvec2(glsl_float::weightsOf(is.volumes)) -
                                    glsl_double::weightsOf(exact.volumes));
    weights.add(std::max(off.x, off.y) / (reach / (edge * condition)) / kRounding);
  }
  const std::string inputs =
      "hits of triangles and slivers to 1:1000, from 0.01 to 1000 edges away, a quarter on the rim";
  test::checkErrors({"intersection", "intersectTriangle, distance t", inputs, "2^-24 (t + L) / c",
                     17, "normal 8.8, numerator 4, denominator 3, quotient 1"},
                    distances);
  test::checkErrors(
      {"intersection", "intersectTriangle and weightsOf", inputs, "2^-24 (t + L) / (L c)", 43,
       "19.7 for each of the four volumes, against 2 c; sum and quotient 3"},
      weights);
}

void measureOrigin(int count) {
  test::Random random(61);
  ErrorStatistics heights;
  while (heights.count() < static_cast<std::uint64_t>(count)) {
    const Corners c = randomCorners(random, 1e-4f, 1e4f);
    const glm::vec3 product = glm::cross(c.v1 - c.v0, c.v2 - c.v0);
    const glm::dvec3 exact = c.normal();
    // Where the corners' own rounding has left nothing of a sliver.
    if (!(glm::length(product) > 0) ||
        !(glm::length(exact) > 1e-5 * c.longestEdge() * c.longestEdge()))
      continue;
    const glm::vec2 uv = glsl_float::uvOfCell(glsl_float::uvCell(aim(random), random.square()));
    const float side = random.below(2) ? 1.0f : -1.0f;
    const float scale = glsl_float::errorScale(c.v0, c.v1, c.v2);
    const glm::vec3 start = glsl_float::leaveSurface(glsl_float::interpolate(c.v0, c.v1, c.v2, uv),
                                                     side * glm::normalize(product), scale);
    const double height =
        side * glm::dot(glm::dvec3(start) - glm::dvec3(c.v0), glm::normalize(exact));
    heights.add(std::abs(height / (kRounding * scale) - 16));
  }
  test::checkErrors({"ray origin", "interpolate and leaveSurface",
                     "triangles and slivers to 1:10000, up to 10000 sizes from the origin",
                     "2^-24 of the error scale; the step is 16", 7.5,
                     "point 3 sqrt 3, sum sqrt 3, tilt and length of the step 0.5"},
                    heights);
}

}  // namespace

TEST_CASE("errors of hits stay below their bounds") {
  measureIntersection(test::kShort);
}
TEST_CASE("errors of hits stay below their bounds, ten million", "[long]") {
  measureIntersection(test::kLong);
}
TEST_CASE("errors of ray origins stay below their bound") {
  measureOrigin(test::kShort);
}
TEST_CASE("errors of ray origins stay below their bound, ten million", "[long]") {
  measureOrigin(test::kLong);
}
