// Some drivers compute mediump in 16 bits. The prelude guards against it in three places; each is
// tested with its guard, and without it to see whether the guard is needed.
#include <catch2/catch.hpp>
#include <cmath>

#include "renderer/shader/composer.h"
#include "tests/gpu/contexts.h"
#include "tests/gpu/probe.h"
#include "tests/shader/random.h"
#include "tests/shader/report.h"

using namespace glimt;
using test::Probe;
using test::TestContext;

namespace {

constexpr std::size_t kCount = std::size_t{1} << 20;
constexpr const char* kPass = "vec4 probe(vec4 a) { return a; }";

// Full mantissas, exponents of all sizes, both signs.
std::vector<Vec4> awkwardTexels() {
  test::Random random(30);
  std::vector<Vec4> texels{Vec4(16777215, 16777213, -16777215, 2049), Vec4(0, -1, 1e-30f, 1e30f)};
  while (texels.size() < kCount) {
    Vec4 texel;
    for (int i = 0; i < 4; ++i) {
      const float mantissa = 1 + random.uniform();
      texel[i] = std::ldexp(random.below(2) ? mantissa : -mantissa,
                            static_cast<int>(random.below(120)) - 60);
    }
    texels.push_back(texel);
  }
  return texels;
}

// Centres of the pixels of rows of `width`.
std::vector<Vec4> pixelCenters(int width) {
  std::vector<Vec4> centers;
  for (int i = 0; i < static_cast<int>(kCount); ++i)
    centers.emplace_back(0.5f + static_cast<float>(i % width), 0.5f + static_cast<float>(i / width),
                         0, 1);
  return centers;
}

// Sixteen times a pixel's index and fifteen more: up to 2^24 - 1.
std::vector<Vec4> wholeNumbers() {
  std::vector<Vec4> numbers;
  for (std::size_t i = 0; i < kCount; ++i) {
    const auto n = static_cast<float>(16 * i + 15);
    numbers.emplace_back(n, -n, n - 1, n - 14);
  }
  return numbers;
}

// Written under a condition, which Mesa makes a choice between 16-bit numbers.
constexpr const char* kWriteTwice = R"(
uniform sampler2D uInput0;
uniform vec2 uProbeStep;
void main() {
  vec4 texel = texture2D(uInput0, pixelCenter() * uProbeStep);
  writeTexel(vec4(1.0));
  if (texel.x > 5.0) writeTexel(texel);
})";

constexpr const char* kCalculate = R"(
vec4 probe(vec4 a) {
  vec2 pixel = floor(pixelCenter());
  float n = 16.0 * (pixel.x + 4096.0 * pixel.y) + 15.0;
  return vec4(n, -n, n - 1.0, n - 14.0);
})";

std::size_t countDifferent(const std::vector<Vec4>& a, const std::vector<Vec4>& b) {
  REQUIRE(a.size() == b.size());
  std::size_t count = 0;
  for (std::size_t i = 0; i < a.size(); ++i) count += a[i] != b[i];
  return count;
}

// The prelude, with one text in it replaced by another.
std::string preludeBut(const std::string& text, const std::string& instead) {
  std::string prelude = shaderText("prelude.glsl");
  const std::size_t at = prelude.find(text);
  REQUIRE(at != std::string::npos);
  return "#version 100\n" + prelude.replace(at, text.size(), instead);
}

void reportWrong(const TestContext& context, const std::string& guard, std::size_t wrong) {
  test::report("{}: without {}: {} of {} wrong{}", context.name(), guard, wrong, kCount,
               wrong ? "" : "; here this guard alone would not be missed");
}

// For guards that are known to be needed.
void expectWrong(const TestContext& context, const std::string& guard, std::size_t wrong) {
  reportWrong(context, guard, wrong);
  const std::string renderer = context.device().info().renderer;
  if (context.egl() && renderer.find("llvmpipe") != std::string::npos) CHECK(wrong > 0);
}

std::size_t countOf(const std::string& word, const std::string& text) {
  std::size_t count = 0;
  for (std::size_t at = text.find(word); at != std::string::npos; at = text.find(word, at + 1))
    ++count;
  return count;
}

}  // namespace

TEST_CASE("float texels arrive exactly") {
  const std::vector<Vec4> texels = awkwardTexels();
  test::onEveryContext([&](const TestContext& context) {
    CAPTURE(context.name());
    const std::string text = kPass + test::probeMain(1);
    Probe guarded(context.device(), {}, kPass);
    CHECK(countDifferent(guarded.run({texels}), texels) == 0);
    Probe unguarded(context.device(), preludeBut("precision highp sampler2D;", "") + text);
    expectWrong(context, "highp samplers", countDifferent(unguarded.run({texels}), texels));
  });
}

TEST_CASE("pixel centres beyond 2048 are exact") {
  constexpr const char* kCenter =
      "vec4 probe(vec4 a) { return vec4(floor(pixelCenter()) + 0.5, 0.0, 1.0); }";
  constexpr const char* kDirect =
      "vec4 probe(vec4 a) { return vec4(floor(gl_FragCoord.xy) + 0.5, 0.0, 1.0); }";
  test::onEveryContext([&](const TestContext& context) {
    for (const int width : {4096, 128}) {
      CAPTURE(context.name(), width);
      const std::vector<Vec4> centers = pixelCenters(width);
      Probe guarded(context.device(), {}, kCenter);
      CHECK(countDifferent(guarded.run({centers}, {}, width), centers) == 0);
      Probe unguarded(context.device(), {}, kDirect);
      expectWrong(context, "a copy of gl_FragCoord",
                  countDifferent(unguarded.run({centers}, {}, width), centers));
    }
  });
}

TEST_CASE("whole numbers of 24 bits are calculated and written exactly") {
  const std::vector<Vec4> numbers = wholeNumbers();
  test::onEveryContext([&](const TestContext& context) {
    CAPTURE(context.name());
    CHECK(countDifferent(Probe(context.device(), {}, kCalculate).run({numbers}), numbers) == 0);
    Probe unguarded(context.device(), preludeBut(" + uZero", "") + kCalculate + test::probeMain(1));
    reportWrong(context, "uZero", countDifferent(unguarded.run({numbers}), numbers));
    Probe twice(context.device(), preludeBut("", "") + kWriteTwice);
    expectWrong(context, "a single write", countDifferent(twice.run({numbers}), numbers));
  });
}

// The test above shows why.
TEST_CASE("every pass writes its texel once, under no condition") {
  const std::string prelude = shaderText("prelude.glsl");
  for (const Pass pass :
       {Pass::camera, Pass::trace, Pass::escape, Pass::light, Pass::accumulate, Pass::display}) {
    CAPTURE(nameOf(pass));
    ShaderRequest request;
    request.pass = pass;
    request.effects.set();
    const std::string text = composeFragmentShader(request);
    CHECK(countOf("writeTexel(", text) == countOf("writeTexel(", prelude) + 1);
    CHECK(countOf("\n  writeTexel(", text) == 1);  // in main, or in what it ends with
    CHECK(countOf("gl_FragColor", text) == countOf("gl_FragColor", prelude));
  }
}

TEST_CASE("a shader with a precision for floats alone is not enough") {
  constexpr const char* kUnguarded = R"(#version 100
precision highp float;
uniform sampler2D uInput0;
uniform vec2 uProbeStep;
void main() { gl_FragColor = texture2D(uInput0, gl_FragCoord.xy * uProbeStep); })";
  const std::vector<Vec4> numbers = wholeNumbers();
  test::onEveryContext([&](const TestContext& context) {
    CAPTURE(context.name());
    expectWrong(context, "any guard",
                countDifferent(Probe(context.device(), kUnguarded).run({numbers}), numbers));
  });
}
