// A ray that leaves a surface does not find the surface again.
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>

#include "tests/shader/glsl_float.h"
#include "tests/shader/random.h"
#include "tests/shader/report.h"

using namespace glimt;
using namespace glimt::glsl_float;

namespace {

struct Corners {
  vec3 v0, v1, v2;
};

// About one in size, thinner by `thin`, and so far from the origin that it loses bits.
Corners randomTriangle(test::Random& random, float offset, float thin) {
  const vec3 center = offset * random.cube();
  const vec3 a = random.cube();
  const vec3 b = random.cube();
  return {center, center + a, center + 0.5f * a + thin * b};
}

// A needle with vertex 0 across from its longest edge, about one in length and `thin` in width.
Corners randomNeedle(test::Random& random, float offset, float thin) {
  const vec3 center = offset * random.cube();
  const vec3 along = random.direction();
  const vec3 across = thin * frameAround(along).tangent;
  return {center, center + across, center + along + random.uniform(0, 1) * across};
}

// At least `lift` radians above the plane.
vec3 leavingDirection(test::Random& random, const vec3& normal, float lift) {
  const Frame frame = frameAround(normal);
  const float angle = random.uniform(0, 6.2831853f);
  return fromFrame(frame, vec3(std::cos(angle) * std::cos(lift), std::sin(angle) * std::cos(lift),
                               std::sin(lift)));
}

struct Counts {
  int hits = 0;
  int rays = 0;
};

template <typename MakeTriangle>
Counts countSelfHits(float thinnest, const MakeTriangle& makeTriangle) {
  test::Random random(20);
  Counts counts;
  while (counts.rays < 2000000) {
    const float offset = random.below(8) ? random.logUniform(0.01f, 1e4f) : 0.0f;
    const Corners t = makeTriangle(random, offset, random.logUniform(thinnest, 1));
    const vec3 cross_product = cross(t.v1 - t.v0, t.v2 - t.v0);
    // At a large offset the rounding of the corners can leave nothing of a thin triangle.
    if (!(glm::length(cross_product) > 1e-6f)) continue;
    const float side = random.below(2) ? 1.0f : -1.0f;
    const vec3 normal = side * normalize(cross_product);
    const vec2 uv = uvOfCell(uvCell(random.weights(), random.square()));
    const vec3 origin =
        leaveSurface(interpolate(t.v0, t.v1, t.v2, uv), normal, errorScale(t.v0, t.v1, t.v2));
    for (int k = 0; k < 4; ++k) {
      const vec3 direction = leavingDirection(random, normal, random.logUniform(1e-3f, 1.57f));
      const TriangleHit hit = intersectTriangle(origin, direction, t.v0, t.v1, t.v2, FAR_AWAY);
      if (!(hit.t < 0)) ++counts.hits;
      ++counts.rays;
    }
  }
  return counts;
}

}  // namespace

TEST_CASE("a ray that leaves a triangle never hits it again") {
  const Counts counts = countSelfHits(0.1f, randomTriangle);
  test::report("ray origin: {} of {} rays hit their own triangle", counts.hits, counts.rays);
  CHECK(counts.hits == 0);
}

TEST_CASE("a ray that leaves a thin triangle never hits it again") {
  const Counts counts = countSelfHits(1e-5f, randomTriangle);
  test::report("ray origin: {} of {} rays hit their own thin triangle", counts.hits, counts.rays);
  CHECK(counts.hits == 0);
}

TEST_CASE(
    "a ray that leaves a needle never hits it again, and starts as close as to other triangles") {
  const Counts counts = countSelfHits(1e-5f, randomNeedle);
  test::report("ray origin: {} of {} rays hit their own needle", counts.hits, counts.rays);
  CHECK(counts.hits == 0);
  test::Random random(21);
  float worst = 0;  // in proportion to the needle's length, around the origin
  for (int i = 0; i < 10000; ++i) {
    const Corners t = randomNeedle(random, 0, random.logUniform(1e-6f, 0.1f));
    worst = std::max(worst, errorScale(t.v0, t.v1, t.v2));
  }
  CHECK(worst < 1.2f);
}
