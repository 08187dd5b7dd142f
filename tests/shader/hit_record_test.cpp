// Field by field: what goes in comes out, within the steps that hit_record.glsl states.
#include <algorithm>
#include <array>
#include <catch2/catch.hpp>
#include <cmath>
#include <limits>
#include <vector>

#include "tests/shader/glsl_float.h"
#include "tests/shader/random.h"
#include "tests/shader/report.h"

using namespace glimt;
using namespace glimt::glsl_float;

namespace {

constexpr float kAlmostOne = 1 - 0x1p-23f;

const HitRecord kPlain(17.0f, 0.0f, vec2(0.25f, 0.5f), vec3(0, 0, 1), vec3(1), 1.0f);

HitRecord roundTrip(const HitRecord& record, const vec4& random) {
  return decodeHitRecord(encodeHitRecord(record, random));
}

bool isInside(const vec2& uv) {
  return uv.x > 0 && uv.y > 0 && uv.x + uv.y < 1;
}

// In cells.
double uvError(const vec2& is, const vec2& was) {
  return 65536 * std::max(std::abs(double(is.x) - was.x), std::abs(double(is.y) - was.y));
}

}  // namespace

TEST_CASE("triangle and side come back from the hit record exactly") {
  test::Random random(5);
  std::vector<float> triangles{
      0, 1, 2, 0x1p22f, TRIANGLE_UNKNOWN - 1, TRIANGLE_UNKNOWN, TRIANGLE_NONE};
  while (triangles.size() < 100000)
    triangles.push_back(static_cast<float>(random.below((1u << 23) - 2)));
  int errors = 0;
  for (const float triangle : triangles) {
    HitRecord record = kPlain;
    record.triangle = triangle;
    record.back = static_cast<float>(random.below(2));
    record.throughput = random.logUniform(1e-11f, 1e6f) * vec3(random.uniform(), 1, 0.5f);
    const vec4 texel = encodeHitRecord(record, random.four());
    const HitRecord out = decodeHitRecord(texel);
    if (isEnded(texel) || out.triangle != triangle || out.back != record.back) ++errors;
  }
  CHECK(errors == 0);
}

TEST_CASE("barycentric weights come back within one cell, inside the triangle") {
  test::Random random(6);
  double worst = 0;
  int outside = 0;
  for (int i = 0; i < 1000000; ++i) {
    HitRecord record = kPlain;
    const vec2 uv = random.weights();
    record.uv = uv * (1 - 4 * 0x1p-16f) + 0x1p-16f;
    const HitRecord out = roundTrip(record, random.four());
    worst = std::max(worst, uvError(out.uv, record.uv));
    if (!isInside(out.uv)) ++outside;
  }
  test::report("hit record: weights off by up to {:.4f} cells", worst);
  CHECK(outside == 0);
  CHECK(worst <= 1.01);
}

TEST_CASE("cells at corners and edges are inside the triangle, two cells away at most") {
  const std::vector<float> edges{0.0f,     1e-30f,       0x1p-17f,     0x1p-16f,     0.5f,
                                 1.0f / 3, 1 - 0x1p-16f, 1 - 0x1p-17f, 1 - 0x1p-24f, 1.0f};
  const std::vector<float> randoms{0.0f, 0x1p-23f, 0.5f - 0x1p-23f, 0.5f, kAlmostOne};
  double worst = 0;
  int outside = 0;
  const auto check = [&](const vec2& uv) {
    for (const float x : randoms) {
      for (const float y : randoms) {
        HitRecord record = kPlain;
        record.uv = uv;
        const vec2 out = roundTrip(record, vec4(0.5f, 0.5f, x, y)).uv;
        if (!isInside(out)) ++outside;
        worst = std::max(worst, uvError(out, uv));
      }
    }
  };
  test::Random random(7);
  for (const float u : edges)
    for (const float v : edges)
      if (u + v <= 1) check({u, v});
  for (int i = 0; i < 20000; ++i) {
    const float u = random.uniform();
    check({u, 1 - u});
    check({u, 0});
    check({0, u});
  }
  test::report("hit record: weights at edges off by up to {:.4f} cells", worst);
  CHECK(outside == 0);
  CHECK(worst <= 2.01);
}

TEST_CASE("directions come back from the hit record within their steps") {
  test::Random random(8);
  double worst = 0;
  const auto check = [&](const vec3& direction) {
    HitRecord record = kPlain;
    record.direction = direction;
    const vec3 out = roundTrip(record, random.four()).direction;
    worst = std::max(worst, test::angleBetween(glm::dvec3(direction), glm::dvec3(out)));
  };
  for (int axis = 0; axis < 3; ++axis) {
    vec3 direction(0);
    direction[axis] = 1;
    check(direction);
    check(-direction);
  }
  for (int i = 0; i < 1000000; ++i) check(random.direction());
  test::report("hit record: directions off by up to {:.3e} rad", worst);
  CHECK(worst < 1.3e-4);
}

TEST_CASE("throughput and weight come back within one step") {
  test::Random random(9);
  double worst_color = 0;   // in steps of a 64th of the largest channel
  double worst_weight = 0;  // in steps of a 127th
  for (int i = 0; i < 1000000; ++i) {
    HitRecord record = kPlain;
    const float largest = random.logUniform(1e-11f, 1e6f);
    record.throughput = largest * vec3(random.uniform(), random.uniform(), random.uniform());
    record.throughput[static_cast<int>(random.below(3))] = largest;
    record.weight = random.uniform();
    const HitRecord out = roundTrip(record, random.four());
    const glm::dvec3 off = glm::abs(glm::dvec3(out.throughput) - glm::dvec3(record.throughput));
    worst_color = std::max(worst_color, 63.5 / largest * std::max({off.x, off.y, off.z}));
    worst_weight = std::max(worst_weight, 127.0 * std::abs(out.weight - record.weight));
  }
  test::report("hit record: throughput off by up to {:.4f} steps, weight by {:.4f}", worst_color,
               worst_weight);
  CHECK(worst_color <= 1.0001);
  CHECK(worst_weight <= 1.0001);
}

TEST_CASE("a field that is rounded up does not spill into its neighbour") {
  const std::array<vec4, 3> randoms{vec4(0.0f), vec4(kAlmostOne),
                                    vec4(kAlmostOne, kAlmostOne, 0, 0)};
  for (const int exponent : {-46, -7, 0, 13}) {
    for (const float largest :
         {127.0f, std::nextafter(127.0f, 0.0f), std::nextafter(127.0f, 128.0f),
          std::nextafter(128.0f, 0.0f), 128.0f}) {
      for (const vec4& random : randoms) {
        CAPTURE(exponent, largest, random.x);
        HitRecord record = kPlain;
        record.throughput = vec3(std::ldexp(largest, exponent));
        const HitRecord out = roundTrip(record, random);
        CHECK(out.triangle == record.triangle);
        CHECK(out.weight == 1.0f);
        CHECK(uvError(out.uv, record.uv) <= 1);
        const vec3 ratio = out.throughput / record.throughput;
        CHECK(std::min({ratio.x, ratio.y, ratio.z}) >= 62.0f / 64);
        CHECK(std::max({ratio.x, ratio.y, ratio.z}) <= 65.0f / 64);
      }
    }
  }
}

TEST_CASE("weights of emission outside [0, 1] are clamped") {
  for (const float weight : {-1.0f, 0.0f, 1.0f, 2.0f, 1e30f}) {
    HitRecord record = kPlain;
    record.weight = weight;
    for (const float random : {0.0f, 0.5f, kAlmostOne})
      CHECK(roundTrip(record, vec4(random)).weight == std::clamp(weight, 0.0f, 1.0f));
  }
}

TEST_CASE("only paths without throughput have ended") {
  constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
  for (const vec3& throughput : {vec3(0), vec3(1e-13f), vec3(-1), vec3(kNan)}) {
    HitRecord record = kPlain;
    record.throughput = throughput;
    CHECK(encodeHitRecord(record, vec4(0.5f)) == vec4(0));
  }
  CHECK(isEnded(vec4(0)));
  for (const vec3& throughput : {vec3(1e-12f), vec3(0, 0, 1e-12f), vec3(1), vec3(1e6f, 0, 0)}) {
    HitRecord record = kPlain;
    record.triangle = 0;
    record.throughput = throughput;
    CHECK_FALSE(isEnded(encodeHitRecord(record, vec4(0))));
    record.back = 1;
    CHECK_FALSE(isEnded(encodeHitRecord(record, vec4(0))));
  }
}
