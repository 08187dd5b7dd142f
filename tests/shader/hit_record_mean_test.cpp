// Rounding moves no mean: over evenly spread random numbers, decoded fields average to what was
// encoded.
#include <algorithm>
#include <catch2/catch.hpp>
#include <vector>

#include "tests/shader/glsl_float.h"
#include "tests/shader/random.h"
#include "tests/shader/report.h"

using namespace glimt;
using namespace glimt::glsl_float;

namespace {

constexpr int kStrata = 4096;

const HitRecord kPlain(17.0f, 0.0f, vec2(0.25f, 0.5f), vec3(0, 0, 1), vec3(1), 1.0f);

struct Mean {
  glm::dvec3 throughput{0};
  glm::dvec2 uv{0};
  double weight = 0;
};

Mean meanOf(const HitRecord& record) {
  Mean mean;
  for (int i = 0; i < kStrata; ++i) {
    // All four take every stratum once, each in another order.
    const auto at = [i](int stride) {
      return (static_cast<float>(i * stride % kStrata) + 0.5f) / kStrata;
    };
    const HitRecord out = decodeHitRecord(encodeHitRecord(record, {at(1), at(3), at(5), at(7)}));
    mean.throughput += glm::dvec3(out.throughput) / double(kStrata);
    mean.uv += glm::dvec2(out.uv) / double(kStrata);
    mean.weight += double(out.weight) / kStrata;
  }
  return mean;
}

// The strata leave half of one of them unresolved: of a step of at most a 63.5th.
constexpr double kResolution = 0.51 / kStrata / 63.5;

// Of the means, relative to the largest channel.
double throughputError(const vec3& throughput) {
  HitRecord record = kPlain;
  record.throughput = throughput;
  const glm::dvec3 off = glm::abs(meanOf(record).throughput - glm::dvec3(throughput));
  return std::max({off.x, off.y, off.z}) / std::max({throughput.x, throughput.y, throughput.z});
}

}  // namespace

TEST_CASE("the mean of a rounded throughput is the throughput") {
  std::vector<vec3> throughputs{vec3(1, 0.5f, 0.25f), vec3(0.8f, 0.003f, 0.0f),
                                vec3(0.3f, 0.6f, 0.1f)};
  for (const float largest : {1e-11f, 1e-6f, 1.0f, 1e6f}) {
    throughputs.push_back(largest * vec3(0.01f, 1, 0.5f));
    throughputs.push_back(largest * vec3(0.99f, 0.123f, 1));
  }
  // About the value at which the exponent changes.
  for (const float edge : {127.0f, std::nextafter(127.0f, 128.0f), 127.4f, 127.99f, 128.0f})
    for (const float power : {0x1p-40f, 0x1p-7f, 1.0f, 0x1p13f})
      throughputs.push_back(edge * power * vec3(1, 0.7f, 0.01f));
  test::Random random(10);
  for (int i = 0; i < 200; ++i)
    throughputs.push_back(random.logUniform(1e-11f, 1e6f) * glm::abs(random.cube()));

  double worst = 0;
  for (const vec3& throughput : throughputs) {
    CAPTURE(throughput.x, throughput.y, throughput.z);
    const double error = throughputError(throughput);
    CHECK(error <= kResolution);
    worst = std::max(worst, error);
  }
  test::report("hit record: mean throughput off by up to {:.2e} of the largest channel", worst);
}

TEST_CASE("a throughput of one is kept exactly") {
  for (const float value : {1.0f, 0.5f, 0x1p-30f, 65536.0f}) {
    HitRecord record = kPlain;
    record.throughput = vec3(value, 0.5f * value, 0);
    CHECK(meanOf(record).throughput == glm::dvec3(record.throughput));
  }
}

TEST_CASE("the mean of a rounded weight is the weight") {
  test::Random random(11);
  std::vector<float> weights{0, 1, 0.5f, 1e-5f, 1 - 1e-5f, 126.0f / 127};
  while (weights.size() < 200) weights.push_back(random.uniform());
  double worst = 0;
  for (const float weight : weights) {
    HitRecord record = kPlain;
    record.weight = weight;
    worst = std::max(worst, std::abs(meanOf(record).weight - weight));
  }
  test::report("hit record: mean weight off by up to {:.2e}", worst);
  CHECK(worst <= 0.51 / kStrata / 127 + 1e-7);
}

TEST_CASE("the mean of rounded barycentric weights is the point, off the edges") {
  test::Random random(12);
  double worst = 0;  // in cells
  for (int i = 0; i < 200; ++i) {
    HitRecord record = kPlain;
    record.uv = random.weights() * (1 - 0x1p-14f) + 0x1p-16f;
    const glm::dvec2 off = 65536.0 * glm::abs(meanOf(record).uv - glm::dvec2(record.uv));
    worst = std::max({worst, off.x, off.y});
  }
  test::report("hit record: mean weights off by up to {:.2e} cells", worst);
  // A float near one has 2^-8 of a cell as its last bit.
  CHECK(worst <= 0x1p-8);
}
