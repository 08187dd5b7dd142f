// Samplers against the densities that they promise.
#include <algorithm>
#include <array>
#include <catch2/catch.hpp>
#include <cmath>
#include <limits>
#include <numbers>

#include "tests/shader/glsl_double.h"
#include "tests/shader/glsl_float.h"
#include "tests/shader/random.h"
#include "tests/shader/report.h"

using namespace glimt;
using namespace glimt::glsl_float;

namespace {

// Pearson's chi-square over 32 x 32 cells that should all be hit alike.
class ChiSquare {
 public:
  // Coordinates in [0, 1], where 1 belongs to the last cell.
  void add(double x, double y) {
    ++counts_.at(static_cast<std::size_t>(cell(y) * kSide + cell(x)));
    ++total_;
  }

  // How many standard deviations it is above its mean.
  double deviations() const {
    const double expected = total_ / static_cast<double>(counts_.size());
    double sum = 0;
    for (const double count : counts_) sum += (count - expected) * (count - expected) / expected;
    const double freedom = static_cast<double>(counts_.size()) - 1;
    return (sum - freedom) / std::sqrt(2 * freedom);
  }

 private:
  static constexpr int kSide = 32;
  static int cell(double x) { return std::min(static_cast<int>(x * kSide), kSide - 1); }

  std::array<double, kSide * kSide> counts_{};
  double total_ = 0;
};

// Of a full turn.
double turn(double x, double y) {
  return std::atan2(y, x) / (2 * std::numbers::pi) + 0.5;
}

constexpr int kSamples = 1000000;

}  // namespace

TEST_CASE("sampleDisk is uniform over the disk") {
  test::Random random(15);
  ChiSquare chi;
  double largest = 0;
  for (int i = 0; i < kSamples; ++i) {
    const glm::dvec2 p(sampleDisk(random.square()));
    chi.add(glm::dot(p, p), turn(p.x, p.y));
    largest = std::max(largest, glm::length(p));
  }
  test::report("disk: chi-square {:+.2f} deviations", chi.deviations());
  CHECK(chi.deviations() < 4);
  CHECK(largest <= 1 + 1e-6);
  CHECK(sampleDisk(vec2(0.5f)) == vec2(0));
}

TEST_CASE("sampleCosineHemisphere has density cos(theta) / pi") {
  test::Random random(16);
  ChiSquare chi;
  double worst_length = 0;
  int below = 0;
  for (int i = 0; i < kSamples; ++i) {
    const vec3 v = sampleCosineHemisphere(random.square());
    // The share of the density that lies above z is 1 - z^2.
    chi.add(double(v.z) * v.z, turn(v.x, v.y));
    worst_length = std::max(worst_length, std::abs(glm::length(glm::dvec3(v)) - 1));
    if (!(v.z >= 0)) ++below;
  }
  test::report("hemisphere: chi-square {:+.2f} deviations, lengths off by {:.2e}", chi.deviations(),
               worst_length);
  CHECK(chi.deviations() < 4);
  CHECK(worst_length < 1e-6);
  CHECK(below == 0);
}

TEST_CASE("the rim of the random square gives directions too") {
  for (const float x : {0.0f, 0.5f, 1 - 0x1p-23f}) {
    for (const float y : {0.0f, 0.5f, 1 - 0x1p-23f}) {
      const vec3 v = sampleCosineHemisphere(vec2(x, y));
      CHECK(v.z >= 0);
      CHECK(glm::length(glm::dvec3(v)) == Approx(1).margin(1e-6));
    }
  }
}

TEST_CASE("sampleTriangle is uniform over the triangle") {
  test::Random random(17);
  ChiSquare chi;
  int outside = 0;
  for (int i = 0; i < kSamples; ++i) {
    const glm::dvec2 uv(sampleTriangle(random.square()));
    if (!(uv.x >= 0 && uv.y >= 0 && uv.x + uv.y <= 1)) ++outside;
    // Strips along the edge opposite to vertex 0 grow with the square of their distance from it.
    const double sum = uv.x + uv.y;
    chi.add(sum * sum, sum > 0 ? uv.x / sum : 0);
  }
  test::report("triangle: chi-square {:+.2f} deviations", chi.deviations());
  CHECK(chi.deviations() < 4);
  CHECK(outside == 0);
}

TEST_CASE("pdfLambert integrates to one over the sphere, and only the lit side counts") {
  constexpr int kSteps = 1000;
  double sum = 0;
  for (int i = 0; i < kSteps; ++i) {
    const double z = -1 + (i + 0.5) * 2 / kSteps;
    sum += glsl_double::pdfLambert(glm::dvec3(std::sqrt(1 - z * z), 0, z)) * 2 / kSteps;
  }
  CHECK(2 * std::numbers::pi * sum == Approx(1).epsilon(1e-12));
  CHECK(pdfLambert(vec3(0, 0.6f, -0.8f)) == 0);
}

TEST_CASE("a sample of the Lambert surface carries its base colour") {
  test::Random random(18);
  const vec3 base_color(0.9f, 0.4f, 0.01f);
  for (int i = 0; i < 1000; ++i) {
    const vec3 wi = sampleLambert(random.square());
    if (wi.z < 1e-3f) continue;
    const vec3 carried = evalLambert(base_color) * wi.z / pdfLambert(wi);
    CHECK(glm::length(carried - base_color) < 1e-6f);
  }
}

TEST_CASE("weights of the two ways to the same light add to one") {
  test::Random random(19);
  for (int i = 0; i < 1000; ++i) {
    const float a = random.logUniform(1e-10f, 1e10f);
    const float b = random.logUniform(1e-10f, 1e10f);
    CHECK(powerHeuristic(a, b) + powerHeuristic(b, a) == Approx(1).epsilon(1e-6));
  }
  CHECK(powerHeuristic(1, 0) == 1);
  CHECK(powerHeuristic(1e-30f, 1e30f) == 0);
  CHECK(powerHeuristic(1e30f, 1e-30f) == 1);
  CHECK(powerHeuristic(0, 1) == 0);
  CHECK(powerHeuristic(0, 0) == 1);
}
