// Frames, samplers and the Lambert surface in float against double: rows of docs/numerics.md.
// u is one rounding, 2^-24. The C library's sine and cosine are off by one last bit, 2 u; a device
// may be off by more, which tests/gpu measures.
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

// One in two near a pole, where the construction changes its side.
glm::vec3 awkwardNormal(test::Random& random) {
  if (random.below(2)) return random.direction();
  const glm::vec2 off = random.logUniform(1e-20f, 1e-1f) * glm::vec2(random.direction());
  const double z = std::sqrt(1 - double(off.x) * off.x - double(off.y) * off.y);
  return {off, random.below(2) ? z : -z};
}

// One in four on the diagonals, the axes or the rim, where the disk's map changes.
glm::vec2 awkwardSquare(test::Random& random) {
  glm::vec2 p = random.square();
  switch (random.below(16)) {
    case 0:
      p.y = p.x;
      break;
    case 1:
      p.y = 1 - p.x;
      break;
    case 2:
      p.x = 0.5f;
      break;
    case 3:
      p.x = random.below(2) ? 0 : 1 - 0x1p-23f;
      break;
    default:
      break;
  }
  return glm::min(p, 1 - 0x1p-23f);
}

double offBy(const glm::vec3& is, const glm::dvec3& exact) {
  return glm::length(glm::dvec3(is) - exact) / kRounding;
}

void measureFrames(int count) {
  test::Random random(64);
  ErrorStatistics axes, directions;
  for (int i = 0; i < count; ++i) {
    const glm::vec3 normal = awkwardNormal(random);
    const glm::vec3 local = random.direction();
    const auto is = glsl_float::frameAround(normal);
    const auto exact = glsl_double::frameAround(glm::dvec3(normal));
    axes.add(std::max(offBy(is.tangent, exact.tangent), offBy(is.bitangent, exact.bitangent)));
    directions.add(
        offBy(glsl_float::fromFrame(is, local), glsl_double::fromFrame(exact, glm::dvec3(local))));
  }
  const std::string inputs = "normals over the sphere, half of them near the poles";
  test::checkErrors(
      {"frames", "frameAround, tangents", inputs, "2^-24", 6, "diagonal 5, other component 2"},
      axes);
  test::checkErrors({"frames", "fromFrame", inputs + "; directions over the sphere", "2^-24", 14,
                     "tangents 6 sqrt 2, products and sums 3 sqrt 3"},
                    directions);
}

void measureSamplers(int count) {
  test::Random random(65);
  ErrorStatistics disk, heights, lengths, triangle;
  for (int i = 0; i < count; ++i) {
    const glm::vec2 square = awkwardSquare(random);
    const glm::dvec2 exact_square(square);
    const glm::dvec2 on_disk =
        glm::dvec2(glsl_float::sampleDisk(square)) - glsl_double::sampleDisk(exact_square);
    disk.add(glm::length(on_disk) / kRounding);
    const glm::dvec3 is(glsl_float::sampleCosineHemisphere(square));
    const glm::dvec3 exact = glsl_double::sampleCosineHemisphere(exact_square);
    heights.add(std::abs(is.z * is.z - exact.z * exact.z) / kRounding);
    lengths.add(std::abs(glm::length(is) - 1) / kRounding);
    const glm::dvec2 weights = glm::abs(glm::dvec2(glsl_float::sampleTriangle(square)) -
                                        glsl_double::sampleTriangle(exact_square));
    triangle.add(std::max(weights.x, weights.y) / kRounding);
  }
  const std::string inputs = "random numbers, a quarter on diagonals, axis and rim";
  test::checkErrors(
      {"sampling", "sampleDisk", inputs, "2^-24", 8, "angle 3.8, sine and cosine 2, product 1"},
      disk);
  test::checkErrors({"sampling", "sampleCosineHemisphere, cosine squared", inputs, "2^-24", 21,
                     "disk twice, dot and difference 3, square root 2"},
                    heights);
  test::checkErrors({"sampling", "sampleCosineHemisphere, length", inputs, "2^-24", 3,
                     "dot 2, difference 1, square root 2, and half of it"},
                    lengths);
  test::checkErrors(
      {"sampling", "sampleTriangle", inputs, "2^-24", 0, "exact for multiples of 2^-23"}, triangle);
}

void measureLambert(int count) {
  test::Random random(66);
  ErrorStatistics values, densities, heuristic;
  const auto relative = [](double is, double exact) {
    return is == exact ? 0 : std::abs(is - exact) / exact / kRounding;
  };
  for (int i = 0; i < count; ++i) {
    const float color = random.below(8) ? random.uniform() : random.logUniform(1e-20f, 1.0f);
    values.add(relative(glsl_float::evalLambert(glm::vec3(color)).x,
                        glsl_double::evalLambert(glm::dvec3(color)).x));
    glm::vec3 wi = random.direction();
    if (random.below(8) == 0) wi.z = random.logUniform(1e-20f, 1e-2f);
    densities.add(relative(glsl_float::pdfLambert(wi), glsl_double::pdfLambert(glm::dvec3(wi))));
    const float pdf = random.logUniform(1e-7f, 1e7f);
    const float other = random.below(4) ? random.logUniform(1e-7f, 1e7f) : pdf;
    heuristic.add(
        relative(glsl_float::powerHeuristic(pdf, other), glsl_double::powerHeuristic(pdf, other)));
  }
  test::checkErrors({"Lambert", "evalLambert", "base colours from 1e-20 to 1", "2^-24 of the value",
                     1.5, "pi as a float 0.5, quotient 1"},
                    values);
  test::checkErrors({"Lambert", "pdfLambert", "directions over the sphere, an eighth grazing",
                     "2^-24 of the value", 1.5, "pi as a float 0.5, quotient 1"},
                    densities);
  test::checkErrors({"Lambert", "powerHeuristic", "densities from 1e-7 to 1e7, a quarter equal",
                     "2^-24 of the value", 5, "ratio squared 3, sum 1, quotient 1"},
                    heuristic);
}

}  // namespace

TEST_CASE("errors of frames stay below their bounds") {
  measureFrames(test::kShort);
}
TEST_CASE("errors of frames stay below their bounds, ten million", "[long]") {
  measureFrames(test::kLong);
}
TEST_CASE("errors of samplers stay below their bounds") {
  measureSamplers(test::kShort);
}
TEST_CASE("errors of samplers stay below their bounds, ten million", "[long]") {
  measureSamplers(test::kLong);
}
TEST_CASE("errors of the Lambert surface stay below their bounds") {
  measureLambert(test::kShort);
}
TEST_CASE("errors of the Lambert surface stay below their bounds, ten million", "[long]") {
  measureLambert(test::kLong);
}
