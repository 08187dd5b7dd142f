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
    const float error_scale = errorScale(t.v0, t.v1, t.v2);
    const vec2 hit = uvOfCell(uvCell(random.weights(), random.square()));
    const vec2 uv = awayFromEdges(t.v0, t.v1, t.v2, hit, error_scale);
    const vec3 origin = leaveSurface(interpolate(t.v0, t.v1, t.v2, uv), normal, error_scale);
    for (int k = 0; k < 4; ++k) {
      const vec3 direction = leavingDirection(random, normal, random.logUniform(1e-3f, 1.57f));
      const TriangleHit again = intersectTriangle(origin, direction, t.v0, t.v1, t.v2, FAR_AWAY);
      if (!(again.t < 0)) ++counts.hits;
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

TEST_CASE("points that rays leave keep away from edges, and are moved by no more than that") {
  test::Random random(22);
  float closest = 1e30f;  // to an edge, in proportion to the offset from the face
  float farthest = 0;     // from where the point was, likewise
  for (int i = 0; i < 100000; ++i) {
    const float thinnest = random.below(2) ? 1.0f : random.logUniform(1e-5f, 1);
    const Corners t = randomTriangle(random, random.logUniform(0.01f, 10), thinnest);
    const float error_scale = errorScale(t.v0, t.v1, t.v2);
    const float offset = error_scale * LEAVE_DISTANCE;
    const vec3 lengths(glm::length(t.v2 - t.v1), glm::length(t.v2 - t.v0),
                       glm::length(t.v1 - t.v0));
    const vec3 heights = glm::length(cross(t.v1 - t.v0, t.v2 - t.v0)) / lengths;
    // Of a point at a corner, of one on an edge, and of one close to it.
    const float along = random.below(4) ? random.logUniform(1e-6f, 1) : 0.0f;
    const vec2 uv(along, random.below(2) ? 0.0f : (1 - along) * random.logUniform(1e-7f, 1));
    const vec2 moved = awayFromEdges(t.v0, t.v1, t.v2, uv, error_scale);
    const vec3 distances = heights * vec3(1 - moved.x - moved.y, moved.x, moved.y);
    const float longest = std::max({lengths.x, lengths.y, lengths.z});
    const float lowest = std::min({heights.x, heights.y, heights.z});
    if (lowest > 160 * offset && longest < 4 * lowest)
      closest = std::min(closest, std::min({distances.x, distances.y, distances.z}) / offset);
    farthest = std::max(farthest, glm::length(interpolate(t.v0, t.v1, t.v2, moved) -
                                              interpolate(t.v0, t.v1, t.v2, uv)) /
                                      offset);
  }
  test::report("ray origin: {:.1f} offsets from an edge, moved by {:.1f} of them at most", closest,
               farthest);
  CHECK(closest > 12);
  CHECK(farthest < 129);
}
