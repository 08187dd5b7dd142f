// Shader functions on the device against the same text in C++, both in single precision.
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <functional>
#include <string>

#include "tests/gpu/contexts.h"
#include "tests/gpu/probe.h"
#include "tests/shader/glsl_float.h"
#include "tests/shader/random.h"
#include "tests/shader/report.h"

using namespace glimt;
using namespace glimt::glsl_float;
using test::Random;

namespace {

constexpr std::size_t kCount = 30000;

const std::vector<std::string> kFiles{"constants.glsl",
                                      "float_fields.glsl",
                                      "octahedral.glsl",
                                      "hit_record.glsl",
                                      "triangle.glsl",
                                      "frame.glsl",
                                      "warp.glsl",
                                      "lambert.glsl",
                                      "ray_origin.glsl",
                                      "multiple_importance.glsl",
                                      "display_transform.glsl"};

struct Case {
  const char* name;
  const char* text;  // of `vec4 probe(vec4 a, vec4 b)`
  Vec4 (*in_cpp)(const Vec4& a, const Vec4& b);
  std::pair<Vec4, Vec4> (*input)(Random& random);
  double tolerance;  // absolute, or relative where values are above one; 0 means to the last bit
};

using Pair = std::pair<Vec4, Vec4>;

Pair normalFloats(Random& random) {
  const float exponent = static_cast<float>(random.below(127)) - 41;
  return {(1.0f + random.four()) * std::exp2(exponent), Vec4(0)};
}
Pair fields(Random& random) {
  Vec4 mantissa, exponent;
  for (int i = 0; i < 4; ++i) {
    mantissa[i] = static_cast<float>(random.below(1u << 23));
    exponent[i] = static_cast<float>(random.below(128)) - 64;
  }
  return {mantissa, exponent};
}
Pair uniform(Random& random) {
  return {random.four(), random.four()};
}
Pair direction(Random& random) {
  return {Vec4(random.direction(), 0), random.four()};
}
Pair densities(Random& random) {
  return {Vec4(random.logUniform(1e-6f, 1e6f), random.logUniform(1e-6f, 1e6f), 0, 0), Vec4(0)};
}
Pair cells(Random& random) {
  return {Vec4(random.weights(), random.square()), Vec4(0)};
}

const Case kCases[]{
    {"powerOfTwo", "return powerOfTwo(b);",
     [](const Vec4&, const Vec4& b) { return powerOfTwo(b); }, fields, 0},
    {"joinFields", "return joinFields(FloatFields(a, b));",
     [](const Vec4& a, const Vec4& b) { return joinFields(FloatFields(a, b)); }, fields, 0},
    {"splitFields, mantissa", "return splitFields(a).mantissa;",
     [](const Vec4& a, const Vec4&) { return splitFields(a).mantissa; }, normalFloats, 0},
    {"splitFields, exponent", "return splitFields(a).exponent;",
     [](const Vec4& a, const Vec4&) { return splitFields(a).exponent; }, normalFloats, 0},
    {"throughputExponent", "return vec4(throughputExponent(a.x));",
     [](const Vec4& a, const Vec4&) { return Vec4(throughputExponent(a.x)); }, normalFloats, 0},
    {"uvCell", "return vec4(uvCell(a.xy, a.zw), uvOfCell(uvCell(a.xy, a.zw)));",
     [](const Vec4& a, const Vec4&) {
       const vec2 cell = uvCell(vec2(a), vec2(a.z, a.w));
       return Vec4(cell, uvOfCell(cell));
     },
     cells, 0},
    {"sampleTriangle", "return vec4(sampleTriangle(a.xy), 0.0, 0.0);",
     [](const Vec4& a, const Vec4&) { return Vec4(sampleTriangle(vec2(a)), 0, 0); }, uniform, 0},
    {"encodeOctahedral", "return vec4(encodeOctahedral(a.xyz), 0.0, 0.0);",
     [](const Vec4& a, const Vec4&) { return Vec4(encodeOctahedral(vec3(a)), 0, 0); }, direction,
     3e-7},
    {"decodeOctahedral", "return vec4(decodeOctahedral(2.0 * a.xy - 1.0), 0.0);",
     [](const Vec4& a, const Vec4&) { return Vec4(decodeOctahedral(2.0f * vec2(a) - 1.0f), 0); },
     uniform, 5e-7},
    {"frameAround and fromFrame",
     "return vec4(fromFrame(frameAround(a.xyz), 2.0 * b.xyz - 1.0), 0.0);",
     [](const Vec4& a, const Vec4& b) {
       return Vec4(fromFrame(frameAround(vec3(a)), 2.0f * vec3(b) - 1.0f), 0);
     },
     direction, 1e-6},
    {"sampleCosineHemisphere", "return vec4(sampleCosineHemisphere(a.xy), 0.0);",
     [](const Vec4& a, const Vec4&) { return Vec4(sampleCosineHemisphere(vec2(a)), 0); }, uniform,
     5e-4},
    {"sampleDisk", "return vec4(sampleDisk(a.xy), 0.0, 0.0);",
     [](const Vec4& a, const Vec4&) { return Vec4(sampleDisk(vec2(a)), 0, 0); }, uniform, 2e-6},
    {"Lambert", "return vec4(evalLambert(a.xyz), pdfLambert(2.0 * b.xyz - 1.0));",
     [](const Vec4& a, const Vec4& b) {
       return Vec4(evalLambert(vec3(a)), pdfLambert(2.0f * vec3(b) - 1.0f));
     },
     uniform, 1e-7},
    {"powerHeuristic", "return vec4(powerHeuristic(a.x, a.y));",
     [](const Vec4& a, const Vec4&) { return Vec4(powerHeuristic(a.x, a.y)); }, densities, 1e-6},
    {"leaveSurface", "return vec4(leaveSurface(a.xyz, b.xyz, 1000.0 * b.w), 0.0);",
     [](const Vec4& a, const Vec4& b) {
       return Vec4(leaveSurface(vec3(a), vec3(b), 1000 * b.w), 0);
     },
     uniform, 2e-7},
    {"awayFromEdges",
     "return vec4(awayFromEdges(a.xyz, a.xyz + vec3(1.0, 0.0, 0.0), b.xyz + vec3(0.0, 2.0, 0.0),"
     " 0.5 * vec2(a.w, b.w) * vec2(a.w, b.w), 4.0), 0.0, 0.0);",
     [](const Vec4& a, const Vec4& b) {
       const vec3 v0(a);
       const vec2 uv = 0.5f * vec2(a.w, b.w) * vec2(a.w, b.w);
       return Vec4(awayFromEdges(v0, v0 + vec3(1, 0, 0), vec3(b) + vec3(0, 2, 0), uv, 4), 0, 0);
     },
     uniform, 1e-6},
    {"displayTransform", "return vec4(displayTransform(a.xyz, 2.0 * b.x), 0.0);",
     [](const Vec4& a, const Vec4& b) { return Vec4(displayTransform(vec3(a), 2 * b.x), 0); },
     uniform, 1e-5},
};

double difference(const Vec4& is, const Vec4& expected) {
  double worst = 0;
  for (int i = 0; i < 4; ++i) {
    if (is[i] == expected[i]) continue;
    const double off =
        std::abs(double(is[i]) - expected[i]) / std::max(1.0, std::abs(double(expected[i])));
    worst = std::max(worst, off >= 0 ? off : std::numeric_limits<double>::infinity());
  }
  return worst;
}

void compare(const test::TestContext& context, const Case& test_case) {
  CAPTURE(context.name(), test_case.name);
  test::Probe probe(context.device(), kFiles,
                    fmt::format("vec4 probe(vec4 a, vec4 b) {{ {} }}", test_case.text), 2);
  Random random(34);
  std::vector<std::vector<Vec4>> inputs(2);
  for (std::size_t i = 0; i < kCount; ++i) {
    const auto [a, b] = test_case.input(random);
    inputs[0].push_back(a);
    inputs[1].push_back(b);
  }
  const std::vector<Vec4> results = probe.run(inputs);
  std::size_t different = 0;
  double worst = 0;
  for (std::size_t i = 0; i < kCount; ++i) {
    const Vec4 expected = test_case.in_cpp(inputs[0][i], inputs[1][i]);
    different += results[i] != expected;
    worst = std::max(worst, difference(results[i], expected));
  }
  test::report("{}: {}: {} of {} differ, by up to {:.2e}", context.name(), test_case.name,
               different, kCount, worst);
  CHECK(worst <= test_case.tolerance);
}

}  // namespace

TEST_CASE("shader functions on the device are those in C++") {
  test::onEveryContext([](const test::TestContext& context) {
    for (const Case& test_case : kCases) compare(context, test_case);
  });
}
