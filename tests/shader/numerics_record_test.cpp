// The hit record and octahedral directions in float against double: rows of docs/numerics.md.
// u is one rounding, 2^-24.
#include <algorithm>
#include <array>
#include <cmath>

#include "tests/shader/error_row.h"
#include "tests/shader/glsl_double.h"
#include "tests/shader/glsl_float.h"
#include "tests/shader/random.h"

using namespace glimt;
using glsl_float::HitRecord;
using test::ErrorStatistics;
using test::kRounding;

namespace {

// One in four beside an axis, or beside a fold of the octahedron.
glm::vec3 awkwardDirection(test::Random& random) {
  glm::vec3 v = random.direction();
  if (random.below(4)) return v;
  const float least = random.below(8) ? random.logUniform(1e-20f, 1e-2f) : 0.0f;
  v[static_cast<int>(random.below(3))] *= least;
  if (random.below(2)) v[static_cast<int>(random.below(3))] *= least;
  return glm::length(v) > 1e-25f ? glm::vec3(glm::normalize(glm::dvec3(v))) : glm::vec3(0, 0, 1);
}

// Random, or as near to its ends as the shaders' random numbers come.
float awkwardRandom(test::Random& random) {
  if (random.below(8)) return random.uniform();
  return random.below(2) ? 0.0f : 1 - 0x1p-23f;
}

glm::vec4 awkwardFour(test::Random& random) {
  return {awkwardRandom(random), awkwardRandom(random), awkwardRandom(random),
          awkwardRandom(random)};
}

// Two in three channels anything, the third the largest; one in four beside a power of two, where
// the exponent changes.
glm::vec3 awkwardThroughput(test::Random& random) {
  float largest = random.logUniform(1e-11f, 1e6f);
  if (random.below(4) == 0) {
    largest =
        std::ldexp(random.below(2) ? 1.0f : 127.0f / 128, static_cast<int>(random.below(50)) - 30);
    const unsigned turns = random.below(3);
    for (unsigned i = 0; i < turns; ++i)
      largest = std::nextafter(largest, random.below(2) ? 1e9f : 0.0f);
  }
  glm::vec3 throughput = largest * glm::vec3(random.uniform(), random.uniform(), random.uniform());
  throughput[static_cast<int>(random.below(3))] = largest;
  return throughput;
}

double uvError(const glm::vec2& is, const glm::vec2& was) {
  return 65536 * std::max(std::abs(double(is.x) - was.x), std::abs(double(is.y) - was.y));
}

void measureRecord(int count) {
  test::Random random(62);
  ErrorStatistics inner, rim, directions, throughputs, weights;
  for (int i = 0; i < count; ++i) {
    const bool on_rim = random.below(4) == 0;
    glm::vec2 uv = random.weights();
    if (on_rim) uv = random.below(2) ? glm::vec2(uv.x, 0) : glm::vec2(uv.x, 1 - uv.x);
    if (!on_rim) uv = uv * (1 - 4 * 0x1p-16f) + 0x1p-16f;
    const float weight = random.below(8) ? random.uniform() : float(random.below(2));
    const HitRecord record(static_cast<float>(random.below(1u << 23)),
                           static_cast<float>(random.below(2)), uv, awkwardDirection(random),
                           awkwardThroughput(random), weight);
    const HitRecord out =
        glsl_float::decodeHitRecord(glsl_float::encodeHitRecord(record, awkwardFour(random)));
    (on_rim ? rim : inner).add(uvError(out.uv, uv));
    directions.add(test::angleBetween(glm::dvec3(record.direction), glm::dvec3(out.direction)));
    const glm::dvec3 off = glm::abs(glm::dvec3(out.throughput) - glm::dvec3(record.throughput));
    const double largest =
        std::max({record.throughput.x, record.throughput.y, record.throughput.z});
    throughputs.add(63.5 / largest * std::max({off.x, off.y, off.z}));
    weights.add(127.0 * std::abs(double(out.weight) - weight));
  }
  const std::string function = "encodeHitRecord, decodeHitRecord: ";
  test::checkErrors({"record", function + "u, v", "two cells and more from the edges",
                     "cells of 2^-16", 1 + 0x1p-7, "one cell; two roundings at 2^16"},
                    inner);
  test::checkErrors({"record", function + "u, v", "on the edges", "cells of 2^-16", 2 + 0x1p-7,
                     "two cells; the same roundings"},
                    rim);
  test::checkErrors(
      {"record", function + "direction", "over the sphere, a quarter beside axes and folds",
       "radians", 3 * std::sqrt(2.0) * 0x1p-15 + 24 * kRounding,
       "half a cell's diagonal, stretched by up to 3; octahedral's 24 u"},
      directions);
  test::checkErrors(
      {"record", function + "throughput", "1e-11 to 1e6, a quarter beside powers of two",
       "63.5ths of the largest channel", 1 + 0x1p-16, "one step; a rounding at 127"},
      throughputs);
  test::checkErrors({"record", function + "weight", "0 to 1, an eighth at its ends", "127ths",
                     1 + 0x1p-15, "one step; four roundings at 127"},
                    weights);
}

void measureOctahedral(int count) {
  test::Random random(63);
  ErrorStatistics angles, lengths;
  for (int i = 0; i < count; ++i) {
    const glm::vec3 v = awkwardDirection(random);
    const glm::vec3 out = glsl_float::decodeOctahedral(glsl_float::encodeOctahedral(v));
    angles.add(test::angleBetween(glm::dvec3(v), glm::dvec3(out)) / kRounding);
    const glm::vec3 other = glsl_float::decodeOctahedral(2.0f * random.square() - 1.0f);
    lengths.add(std::abs(glm::length(glm::dvec3(other)) - 1) / kRounding);
  }
  test::checkErrors({"octahedral", "encodeOctahedral, decodeOctahedral",
                     "over the sphere, a quarter beside axes and folds", "2^-24 radians", 24,
                     "square 4.2, stretched by up to 3; unfolding 4.7, by sqrt 3; normalize 1"},
                    angles);
  test::checkErrors({"octahedral", "decodeOctahedral, length", "over the square", "2^-24", 4.5,
                     "normalize: dot 1.5, square root, quotient and product 1 each"},
                    lengths);
}

}  // namespace

TEST_CASE("errors of the hit record stay below their bounds") {
  measureRecord(test::kShort);
}
TEST_CASE("errors of the hit record stay below their bounds, ten million", "[long]") {
  measureRecord(4 * test::kLong);  // a quarter is on the rim
}
TEST_CASE("errors of octahedral directions stay below their bounds") {
  measureOctahedral(test::kShort);
}
TEST_CASE("errors of octahedral directions stay below their bounds, ten million", "[long]") {
  measureOctahedral(test::kLong);
}
