#include "renderer/probes/arithmetic_probes.h"

#include <array>
#include <cmath>
#include <limits>

#include "renderer/gl/program.h"
#include "renderer/probes/probe.h"
#include "renderer/shader/composer.h"

namespace glimt {
namespace {

// Sums that 16 bits, or 8, would not hold.
constexpr std::array kSummands{Vec4(8388607, -0.5f, 0x1p-30f, 1e30f),
                               Vec4(8388608, 0.25f, 0x1.8p-30f, 3e30f), Vec4(-3, 1024, 0, -2e30f)};

constexpr const char* kWriteUniform = "uniform vec4 uValue;\nvoid main() { writeTexel(uValue); }\n";

// The test of accumulate.glsl, on the value that came in and on values made here.
constexpr const char* kIsGood = R"(
float isGood(float value) {
  return value >= 0.0 && value <= 1.0e30 ? 1.0 : 0.0;
}
vec4 probe(vec4 a) {
  return vec4(isGood(a.x), isGood(a.y * a.y), isGood(a.y * a.y - a.z * a.z), isGood(a.w));
})";

}  // namespace

bool addsExactly(const gl::Device& device) {
  constexpr int kSize = 16;
  const gl::Target target(gl::Texture::floats(device.gl(), device.floatForm(), kSize, 1));
  target.clear();
  target.bind();
  gl::Program program(device.gl(), "sum", composeVertexShader(), composeProbe({}, kWriteUniform));
  program.use();
  program.set("uZero", Vec4(0));
  Vec4 sum(0);
  for (const Vec4& summand : kSummands) {
    program.set("uValue", summand);
    device.draw({0, 0, kSize, 1}, {true, gl::Limit::none});
    sum += summand;
  }
  for (const Vec4& texel : target.readFloats())
    if (texel != sum) return false;
  return true;
}

bool detectsNonfinite(const gl::Device& device) {
  constexpr float kInfinity = std::numeric_limits<float>::infinity();
  constexpr float kHuge = 1e30f;  // its square is an infinity, the difference of two is a NaN
  Probe probe(device, {}, kIsGood);
  std::vector<Vec4> values;
  for (const float bad : {std::nanf(""), -std::nanf(""), kInfinity, -kInfinity, -1.0f, 2e30f})
    values.emplace_back(bad, kHuge, kHuge, 1);
  for (const float good : {0.0f, 1.0f, 16777215.0f, 1e30f}) values.emplace_back(good, 1, 1, good);
  const std::size_t bad = 6;
  const std::vector<Vec4> found = probe.run({values});
  for (std::size_t i = 0; i < found.size(); ++i)
    if (found[i] != (i < bad ? Vec4(0, 0, 0, 1) : Vec4(1))) return false;
  return true;
}

bool keepsDenormals(const gl::Device& device) {
  constexpr float kDenormal = 0x1p-130f;
  Probe probe(device, {}, "vec4 probe(vec4 a) { return a * a.y; }");
  return probe.run({{Vec4(kDenormal, 1048576, 0, 0)}})[0].x == kDenormal * 1048576;
}

}  // namespace glimt
