// The intersection in float against the same text in double.
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <limits>

#include "tests/shader/glsl_double.h"
#include "tests/shader/glsl_float.h"
#include "tests/shader/random.h"
#include "tests/shader/report.h"

using namespace glimt;

namespace {

struct Case {
  glm::vec3 origin, direction, v0, v1, v2;
};

glsl_float::TriangleHit inFloat(const Case& c) {
  return glsl_float::intersectTriangle(c.origin, c.direction, c.v0, c.v1, c.v2,
                                       glsl_float::FAR_AWAY);
}

glsl_double::TriangleHit inDouble(const Case& c) {
  return glsl_double::intersectTriangle(glm::dvec3(c.origin), glm::dvec3(c.direction),
                                        glm::dvec3(c.v0), glm::dvec3(c.v1), glm::dvec3(c.v2),
                                        glsl_double::FAR_AWAY);
}

// About one in size, thinner by `thin`, aimed at from `distance` away; some rays pass it by.
Case randomCase(test::Random& random, float distance, float thin) {
  const glm::vec3 v0 = random.cube();
  const glm::vec3 a = random.direction();
  const glm::vec3 b = random.direction();
  const glm::vec3 v1 = v0 + a;
  const glm::vec3 v2 = v0 + random.uniform() * a + thin * b;
  const glm::vec2 uv = 1.2f * random.weights() - 0.1f;
  const glm::vec3 direction = random.direction();
  const glm::vec3 target = glsl_float::interpolate(v0, v1, v2, uv);
  return {target - distance * direction, direction, v0, v1, v2};
}

// How well the triangle's edges span the plane across the ray: what errors grow with the inverse
// of.
double condition(const Case& c) {
  const glm::dvec3 a = glm::dvec3(c.v1) - glm::dvec3(c.v0);
  const glm::dvec3 b = glm::dvec3(c.v2) - glm::dvec3(c.v0);
  const glm::dvec3 d(c.direction);
  return std::abs(glm::dot(glm::cross(a, b), d)) / glm::length(a) / glm::length(b) / glm::length(d);
}

// Distance of the hit point from the nearest edge, by its weights.
double margin(const glsl_double::TriangleHit& hit) {
  const glm::dvec3 w = hit.volumes / (hit.volumes.x + hit.volumes.y + hit.volumes.z);
  return std::min({w.x, w.y, w.z});
}

}  // namespace

TEST_CASE("distances in float are those in double") {
  test::Random random(21);
  double worst = 0;  // relative, times the condition
  double worst_weight = 0;
  int hits = 0;
  for (int i = 0; i < 1000000; ++i) {
    const float distance = random.logUniform(0.01f, 1e3f);
    const Case c = randomCase(random, distance, random.logUniform(0.1f, 1));
    const auto is = inFloat(c);
    const auto should_be = inDouble(c);
    if (is.t < 0 || should_be.t < 0) continue;
    ++hits;
    // What is lost in subtracting the origin from the corners is absolute, not relative.
    const double size = std::max({should_be.t, 1.0});
    worst = std::max(worst, std::abs(is.t - should_be.t) / size * condition(c));
    const glm::dvec2 off =
        glm::dvec2(glsl_float::weightsOf(is.volumes)) - glsl_double::weightsOf(should_be.volumes);
    worst_weight = std::max(worst_weight, glm::length(off) / size * condition(c));
  }
  test::report("triangle: {} hits, t off by up to {:.2e} relative, weights by {:.2e} per distance",
               hits, worst, worst_weight);
  CHECK(hits > 500000);
  CHECK(worst < 1e-6);
  CHECK(worst_weight < 1e-5);
}

TEST_CASE("hits and misses in float are those in double, off the edges") {
  test::Random random(22);
  int wrong = 0;
  int sure = 0;
  for (int i = 0; i < 1000000; ++i) {
    const float distance = random.logUniform(0.01f, 1e3f);
    const Case c = randomCase(random, distance, random.logUniform(0.1f, 1));
    const auto should_be = inDouble(c);
    const double doubt = 1e-5 * std::max(distance, 1.0f) / condition(c);
    if (!(std::abs(margin(should_be)) > doubt)) continue;
    ++sure;
    if ((inFloat(c).t >= 0) != (should_be.t >= 0)) ++wrong;
  }
  test::report("triangle: {} of {} rays that pass an edge at a distance are wrong", wrong, sure);
  CHECK(sure > 400000);
  CHECK(wrong == 0);
}

TEST_CASE("hits of slivers are sane numbers") {
  test::Random random(23);
  double worst = 0;
  int bad = 0;
  int hits = 0;
  for (int i = 0; i < 1000000; ++i) {
    const float distance = random.logUniform(0.01f, 1e3f);
    const Case c = randomCase(random, distance, random.logUniform(1e-6f, 1e-2f));
    const auto is = inFloat(c);
    if (is.t < 0) continue;
    ++hits;
    const glm::vec2 uv = glsl_float::weightsOf(is.volumes);
    const bool sane = uv.x >= 0 && uv.y >= 0 && uv.x + uv.y <= 1.000001f && is.t < 1e30f;
    if (!sane) ++bad;
    const double off = std::abs(is.t - double(distance)) / std::max(distance, 1.0f);
    worst = std::max(worst, off * condition(c));
  }
  test::report("triangle: {} hits of slivers, {} not sane, t off by up to {:.2e}", hits, bad,
               worst);
  CHECK(hits > 1000);
  CHECK(bad == 0);
  CHECK(worst < 1e-4);
}

TEST_CASE("distances count from zero, up to but without the farthest") {
  const glm::vec3 v0(0, 0, 1), v1(1, 0, 1), v2(0, 1, 1);
  const glm::vec3 to(0, 0, 1);
  const auto hit = [&](float z, float far) {
    return glsl_float::intersectTriangle(glm::vec3(0.25f, 0.25f, z), to, v0, v1, v2, far).t;
  };
  CHECK(hit(0, 2) == 1);
  CHECK(hit(1, 2) == 0);
  CHECK(hit(2, 2) < 0);
  CHECK(hit(0, 1) < 0);
  CHECK(hit(0, std::nextafter(1.0f, 2.0f)) == 1);
}

TEST_CASE("the sign of facingOf tells the side") {
  const glm::vec3 v0(0, 0, 0), v1(1, 0, 0), v2(0, 1, 0);  // counter-clockwise seen from +z
  const auto facing = [&](float z) {
    return glsl_float::facingOf(glsl_float::intersectTriangle(glm::vec3(0.25f, 0.25f, z),
                                                              glm::vec3(0, 0, -z), v0, v1, v2,
                                                              glsl_float::FAR_AWAY)
                                    .volumes);
  };
  CHECK(facing(1) == -2);  // twice the dot product with a normal as long as the double area
  CHECK(facing(-1) == 2);
}

TEST_CASE("the weights are those of vertices 1 and 2") {
  const glm::vec3 v0(0, 0, 0), v1(1, 0, 0), v2(0, 1, 0);
  const auto hit = glsl_float::intersectTriangle(glm::vec3(0.25f, 0.5f, 1), glm::vec3(0, 0, -1), v0,
                                                 v1, v2, glsl_float::FAR_AWAY);
  CHECK(glsl_float::weightsOf(hit.volumes) == glm::vec2(0.25f, 0.5f));
  CHECK(glsl_float::interpolate(v0, v1, v2, {0.25f, 0.5f}) == glm::vec3(0.25f, 0.5f, 0));
}

TEST_CASE("a ray in the triangle's plane misses it") {
  const glm::vec3 v0(0, 0, 0), v1(1, 0, 0), v2(0, 1, 0);
  for (const float z : {0.0f, 1.0f}) {
    const auto hit = glsl_float::intersectTriangle(glm::vec3(-1, 0.25f, z), glm::vec3(1, 0, 0), v0,
                                                   v1, v2, glsl_float::FAR_AWAY);
    CHECK(hit.t < 0);
  }
}
