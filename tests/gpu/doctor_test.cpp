// The doctor calls what is right right, and what is wrong wrong.
#include "renderer/doctor.h"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>

#include "tests/gpu/altered_context.h"
#include "tests/gpu/coincident_triangles.h"
#include "tests/gpu/contexts.h"
#include "tests/shader/report.h"
#include "tests/unit/expect_error.h"

using namespace glimt;
using test::coincidentTriangles;
using test::TestContext;

namespace {

// The first context that can be had, with functions of which some are wrong.
ContextHandle wrongContext(const std::function<void(gl::Functions&)>& alter) {
  const TestContext& first = test::contexts().front();
  first.makeCurrent();
  return ContextHandle(test::alteredContext(first.context(), alter));
}

// Functions of GL know nothing but their arguments.
const gl::Functions& realFunctions() {
  return test::contexts().front().gl();
}

template <class Change>
void readChanged(GLsizei width, GLsizei height, void* pixels, const Change& change) {
  auto* values = static_cast<float*>(pixels);
  std::transform(values, values + 4 * width * height, values, change);
}

void readEightBits(GLint x, GLint y, GLsizei width, GLsizei height, GLenum format, GLenum type,
                   void* pixels) {
  realFunctions().ReadPixels(x, y, width, height, format, type, pixels);
  if (type != GL_FLOAT) return;
  readChanged(width, height, pixels,
              [](float value) { return std::round(std::clamp(value, 0.0f, 1.0f) * 255) / 255; });
}

// Right in the one texel by which float targets are chosen, and a bit short everywhere else.
void readTwentyThreeBits(GLint x, GLint y, GLsizei width, GLsizei height, GLenum format,
                         GLenum type, void* pixels) {
  realFunctions().ReadPixels(x, y, width, height, format, type, pixels);
  if (type != GL_FLOAT || width * height == 1) return;
  readChanged(width, height, pixels, [](float value) {
    int exponent = 0;
    const float mantissa = std::frexp(value, &exponent);
    return std::isfinite(value) ? std::ldexp(std::trunc(mantissa * 0x1p23f), exponent - 23) : value;
  });
}

void smallTextures(GLenum name, GLint* value) {
  realFunctions().GetIntegerv(name, value);
  if (name == GL_MAX_TEXTURE_SIZE) *value = 64;
}

void neverBlend(GLenum capability) {
  if (capability != GL_BLEND) realFunctions().Enable(capability);
}

void halfPrecision(GLenum, GLenum, GLint* range, GLint* precision) {
  range[0] = range[1] = 15;
  *precision = 10;
}

const Finding& named(const std::vector<Finding>& findings, const std::string& name) {
  const auto found = std::find_if(findings.begin(), findings.end(),
                                  [&](const Finding& finding) { return finding.name == name; });
  REQUIRE(found != findings.end());
  return *found;
}

// As the library gets it.
ContextHandle handleOf(const TestContext& context) {
  return ContextHandle(test::alteredContext(context.context(), [](gl::Functions&) {}));
}

RenderSettings tinyPicture(const std::string& traversal) {
  RenderSettings settings;
  settings.traversal = traversal;
  settings.width = settings.height = 4;
  settings.bounces = 0;
  return settings;
}

}  // namespace

TEST_CASE("the doctor finds nothing fatal on any context here") {
  test::onEveryContext([](const TestContext& context) {
    ContextHandle handle = handleOf(context);
    const std::vector<Finding> findings = examine(handle);
    CHECK(findings.size() == 16);
    for (const Finding& finding : findings) {
      CAPTURE(context.name(), finding.name, finding.result, finding.consequence);
      test::report("{}: {}: {}: {}", context.name(), finding.name, nameOf(finding.verdict),
                   finding.result);
      CHECK(finding.verdict != Verdict::fatal);
      CHECK_FALSE(finding.result.empty());
      CHECK_FALSE(finding.consequence.empty());
    }
    CHECK(isUsable(findings));
  });
}

TEST_CASE("targets that give back 8 bits are fatal, and there is no more to examine") {
  ContextHandle context = wrongContext([](gl::Functions& gl) { gl.ReadPixels = readEightBits; });
  const std::vector<Finding> findings = examine(context);
  const Finding& targets = named(findings, "float targets");
  CHECK(targets.verdict == Verdict::fatal);
  CHECK(targets.result.find("RGBA32F complete but not exact") != std::string::npos);
  CHECK_FALSE(isUsable(findings));
}

TEST_CASE("targets that lose one bit are fatal to numbers and records") {
  ContextHandle context =
      wrongContext([](gl::Functions& gl) { gl.ReadPixels = readTwentyThreeBits; });
  const std::vector<Finding> findings = examine(context);
  CHECK(named(findings, "float targets").verdict == Verdict::ok);
  for (const char* name :
       {"guards against 16 bits", "whole numbers", "numbers of all sizes", "hit record"}) {
    CAPTURE(name);
    CHECK(named(findings, name).verdict == Verdict::fatal);
  }
  // Smaller indices are still right.
  const Finding& addresses = named(findings, "texel addresses");
  CHECK(addresses.verdict == Verdict::warning);
  CHECK(addresses.result.find("none in one of") != std::string::npos);
  CHECK_FALSE(isUsable(findings));
}

TEST_CASE("blending that replaces instead of adding is fatal, where the driver claims it") {
  ContextHandle context = wrongContext([](gl::Functions& gl) { gl.Enable = neverBlend; });
  const Finding blending = named(examine(context), "float blending");
  const bool claimed = test::contexts().front().device().floatBlending();
  CHECK(blending.verdict == (claimed ? Verdict::fatal : Verdict::ok));
}

TEST_CASE("shaders that claim half precision are fatal") {
  ContextHandle context =
      wrongContext([](gl::Functions& gl) { gl.GetShaderPrecisionFormat = halfPrecision; });
  CHECK(named(examine(context), "highp floats").verdict == Verdict::fatal);
}

TEST_CASE("small textures are a warning, and too small for a scene an error with the number") {
  ContextHandle context = wrongContext([](gl::Functions& gl) { gl.GetIntegerv = smallTextures; });
  const Finding size = named(examine(context), "texture size");
  CHECK(size.verdict == Verdict::warning);
  CHECK(size.consequence.find("1,365 triangles") != std::string::npos);
  const std::string message = messageOf(
      ErrorKind::input, [&] { Renderer(context, coincidentTriangles(1366), RenderSettings()); });
  CHECK(message.find("1,366 triangles") != std::string::npos);
  CHECK(message.find("1,365 fit") != std::string::npos);
}

TEST_CASE("traversal linear is refused more triangles than a loop makes turns") {
  test::onEveryContext([](const TestContext& context) {
    CAPTURE(context.name());
    ContextHandle handle = handleOf(context);
    const RenderSettings settings = tinyPicture("linear");
    const std::string message = messageOf(
        ErrorKind::input, [&] { Renderer(handle, coincidentTriangles(65537), settings); });
    CHECK(message.find("65,537") != std::string::npos);
    CHECK(message.find("--traversal auto") != std::string::npos);
    // A driver makes that many: see loop_limit_test.cpp.
    Renderer(handle, coincidentTriangles(60000), settings).renderSample();
  });
}

TEST_CASE("what the last sample lost to traversals cut short is told") {
  test::onEveryContext([](const TestContext& context) {
    CAPTURE(context.name());
    ContextHandle handle = handleOf(context);
    const RenderSettings settings = tinyPicture("skip");
    Renderer small(handle, coincidentTriangles(1000), settings);
    small.renderSample();
    CHECK(small.nonfinitePixels() == 0);
    CHECK(small.lastLosses().cut_short == 0);
    // All triangles fill the same box, so the tree is of no use.
    Renderer crowded(handle, coincidentTriangles(70000), settings);
    crowded.renderSample();
    const Losses losses = crowded.lastLosses();
    CHECK(losses.cut_short == crowded.nonfinitePixels());
    CHECK(losses.not_finite == 0);
    const auto limit = crowded.loopLimit();
    if (limit) CHECK(losses.cut_short > 0);
    if (context.device().info().renderer.find("llvmpipe") != std::string::npos)
      CHECK(limit.has_value());
  });
}
