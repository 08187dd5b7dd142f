// No ray passes between triangles that share an edge or a corner.
#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>
#include <vector>

#include "tests/shader/glsl_float.h"
#include "tests/shader/random.h"
#include "tests/shader/report.h"

using namespace glimt;
using namespace glimt::glsl_float;

namespace {

// Triangles around a common corner, a bent disk without a border near the corner.
struct Fan {
  vec3 center;
  std::vector<vec3> ring;

  const vec3& at(std::size_t i) const { return ring[i % ring.size()]; }
};

Fan randomFan(test::Random& random, float scale, const vec3& place) {
  const std::size_t corners = 3 + random.below(8);
  const Frame frame = frameAround(random.direction());
  Fan fan{place, {}};
  for (std::size_t i = 0; i < corners; ++i) {
    const float angle = 2 * std::numbers::pi_v<float> *
                        (static_cast<float>(i) + random.uniform(0.05f, 0.8f)) /
                        static_cast<float>(corners);
    const float radius = random.uniform(0.3f, 1);
    const vec3 local(radius * std::cos(angle), radius * std::sin(angle),
                     random.uniform(-0.2f, 0.2f));
    fan.ring.push_back(place + scale * fromFrame(frame, local));
  }
  return fan;
}

// Whether all triangles clearly show the same side: then a ray cannot pass a fold.
bool seenFromOneSide(const Fan& fan, const vec3& direction) {
  double least = 1;
  double most = -1;
  for (std::size_t i = 0; i < fan.ring.size(); ++i) {
    const glm::dvec3 center(fan.center);
    const glm::dvec3 n =
        glm::cross(glm::dvec3(fan.at(i)) - center, glm::dvec3(fan.at(i + 1)) - center);
    const double facing = glm::dot(n, glm::dvec3(direction)) / glm::length(n);
    least = std::min(least, facing);
    most = std::max(most, facing);
  }
  return least > 0.01 || most < -0.01;
}

int countHits(const Fan& fan, const vec3& origin, const vec3& direction) {
  int hits = 0;
  for (std::size_t i = 0; i < fan.ring.size(); ++i) {
    const bool turned = i % 2;  // triangles need not list their corners in the same order
    const TriangleHit hit =
        turned
            ? intersectTriangle(origin, direction, fan.at(i + 1), fan.center, fan.at(i), FAR_AWAY)
            : intersectTriangle(origin, direction, fan.center, fan.at(i), fan.at(i + 1), FAR_AWAY);
    if (hit.t >= 0) ++hits;
  }
  return hits;
}

enum class Aim { edge, corner };

struct Counts {
  int rays = 0;
  int misses = 0;
  int several = 0;
};

// Rays at the shared corner, and at points of shared edges. `place` is in sizes of the fan.
Counts shoot(std::uint32_t seed, float place, Aim aim) {
  test::Random random(seed);
  Counts counts;
  while (counts.rays < 500000) {
    const float scale = random.logUniform(1e-3f, 1e3f);
    const Fan fan = randomFan(random, scale, place * scale * random.cube());
    for (int k = 0; k < 16; ++k) {
      const vec3 direction = random.direction();
      if (!seenFromOneSide(fan, direction)) continue;
      const vec3& corner = fan.at(random.below(static_cast<std::uint32_t>(fan.ring.size())));
      const float along = aim == Aim::edge ? random.uniform(0.01f, 0.9f) : 0.0f;
      const vec3 target = fan.center + along * (corner - fan.center);
      const vec3 origin = target - scale * random.logUniform(0.1f, 1e3f) * direction;
      const int hits = countHits(fan, origin, direction);
      ++counts.rays;
      if (hits == 0) ++counts.misses;
      if (hits > 1) ++counts.several;
    }
  }
  return counts;
}

}  // namespace

TEST_CASE("rays through shared edges always hit a triangle") {
  for (const float place : {0.0f, 1.0f, 100.0f}) {
    const Counts counts = shoot(24, place, Aim::edge);
    test::report("watertight edges: {} of {} rays missed, {} hit several, fans {} sizes away",
                 counts.misses, counts.rays, counts.several, place);
    CHECK(counts.misses == 0);
  }
}

TEST_CASE("rays through shared corners always hit a triangle where the arithmetic is exact") {
  test::Random random(25);
  Counts counts;
  const auto whole = [&] { return static_cast<float>(random.below(17)) - 8; };
  while (counts.rays < 500000) {
    // Camera rays through the corners of a regular mesh are like this.
    Fan fan{vec3(whole(), whole(), whole()), {}};
    for (const auto& [x, y] : {std::pair(1, 0), {1, 1}, {0, 1}, {-1, 0}, {-1, -1}, {0, -1}})
      fan.ring.push_back(fan.center + vec3(x, y, random.below(2)));
    const vec3 direction(whole() / 8, whole() / 8, 4);
    if (!seenFromOneSide(fan, direction)) continue;
    const int hits = countHits(fan, fan.center - 4.0f * direction, direction);
    ++counts.rays;
    if (hits == 0) ++counts.misses;
  }
  CHECK(counts.misses == 0);
}

// Edge functions of different edges are rounded on their own, so at a corner they may contradict
// each other. The hole is as large as the last bits of a distance: only rays that aim at it find
// it.
TEST_CASE("few rays that aim at a shared corner slip through") {
  for (const float place : {0.0f, 1.0f, 100.0f}) {
    const Counts counts = shoot(26, place, Aim::corner);
    test::report("watertight corners: {} of {} rays missed, {} hit several, fans {} sizes away",
                 counts.misses, counts.rays, counts.several, place);
    CHECK(counts.misses < counts.rays / 40);
  }
}
