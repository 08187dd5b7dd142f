#include "renderer/probes/guard_probes.h"

#include <algorithm>

#include "renderer/core/error.h"
#include "renderer/probes/number_probes.h"
#include "renderer/probes/probe.h"
#include "renderer/shader/composer.h"

namespace glimt {
namespace {

constexpr std::size_t kCount = std::size_t{1} << 20;
constexpr int kWide = 4096;
constexpr int kNarrow = 128;

constexpr const char* kPass = "vec4 probe(vec4 a) { return a; }";

constexpr const char* kCenter =
    "vec4 probe(vec4 a) { return vec4(floor(pixelCenter()) + 0.5, 0.0, 1.0); }";
constexpr const char* kDirectCenter =
    "vec4 probe(vec4 a) { return vec4(floor(gl_FragCoord.xy) + 0.5, 0.0, 1.0); }";

constexpr const char* kCalculate = R"(
vec4 probe(vec4 a) {
  vec2 pixel = floor(pixelCenter());
  float n = 16.0 * (pixel.x + 4096.0 * pixel.y) + 15.0;
  return vec4(n, -n, n - 1.0, n - 14.0);
})";

// Written under a condition, which Mesa makes a choice between 16-bit numbers.
constexpr const char* kWriteTwice = R"(
uniform sampler2D uInput0;
uniform vec2 uProbeStep;
void main() {
  vec4 texel = texture2D(uInput0, pixelCenter() * uProbeStep);
  writeTexel(vec4(1.0));
  if (texel.x > 5.0) writeTexel(texel);
})";

constexpr const char* kUnguarded = R"(#version 100
precision highp float;
uniform sampler2D uInput0;
uniform vec2 uProbeStep;
void main() { gl_FragColor = texture2D(uInput0, gl_FragCoord.xy * uProbeStep); })";

// Centres of the pixels of rows of `width`.
std::vector<Vec4> pixelCenters(std::size_t count, int width) {
  std::vector<Vec4> centers;
  for (int i = 0; i < static_cast<int>(count); ++i)
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

// The prelude, with one text in it replaced by another.
std::string preludeBut(const std::string& text, const std::string& instead) {
  std::string prelude = shaderText("prelude.glsl");
  const std::size_t at = prelude.find(text);
  if (at == std::string::npos)
    throw Error(ErrorKind::failed, "the prelude has no '" + text + "' to do without");
  return "#version 100\n" + prelude.replace(at, text.size(), instead);
}

GuardProbe compare(const std::string& guard, Probe guarded, Probe unguarded,
                   const std::vector<Vec4>& texels, int width = kWide) {
  return {guard, texels.size(), countDifferent(guarded.run({texels}, {}, width), texels),
          countDifferent(unguarded.run({texels}, {}, width), texels)};
}

GuardProbe compareCenters(const gl::Device& device, int width) {
  const auto rows = std::min(static_cast<int>(kCount) / width, device.maxTextureSize());
  const std::size_t count = static_cast<std::size_t>(rows) * static_cast<std::size_t>(width);
  return compare("a copy of gl_FragCoord", Probe(device, {}, kCenter),
                 Probe(device, {}, kDirectCenter), pixelCenters(count, width), width);
}

}  // namespace

std::vector<GuardProbe> probeGuards(const gl::Device& device) {
  const std::vector<Vec4> numbers = wholeNumbers();
  const std::string lowp = preludeBut("precision highp sampler2D;", "");
  const std::string no_sum = preludeBut(" + uZero", "");
  const std::string prelude = preludeBut("", "");
  return {compare("highp samplers", Probe(device, {}, kPass),
                  Probe(device, lowp + kPass + probeMain(1)), scaledIntegers(kCount)),
          compareCenters(device, kWide),
          compareCenters(device, kNarrow),
          compare(kGuardOfSum, Probe(device, {}, kCalculate),
                  Probe(device, no_sum + kCalculate + probeMain(1)), numbers),
          compare("a single write", Probe(device, {}, kPass), Probe(device, prelude + kWriteTwice),
                  numbers),
          compare("any guard", Probe(device, {}, kPass), Probe(device, kUnguarded), numbers)};
}

}  // namespace glimt
