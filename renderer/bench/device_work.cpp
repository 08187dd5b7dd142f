#include "renderer/bench/device_work.h"

#include <fmt/format.h>

namespace glimt {
namespace {

constexpr const char* kTests = "G tests/s";
constexpr const char* kFetches = "G fetches/s";
constexpr int kStepsPerTurn = 8;
constexpr std::size_t kKib = 1024;
constexpr std::size_t kMib = kKib * kKib;

// Eight chains side by side, so that none waits for itself. Nothing is known when compiling, since
// uZero might be anything.
constexpr const char* kMultiplyAdd = R"(
#define STEP a = a * factor + term; b = b * factor + term;
void main() {
  vec4 a = pixelCenter().xyxy * vec4(1.0, 2.0, 3.0, 4.0);
  vec4 b = a + 0.5;
  float factor = 0.999 + uZero.x;
  float term = 0.001 + uZero.y;
  for (int i = 0; i < TURNS; i++) {
    STEP STEP STEP STEP STEP STEP STEP STEP
  }
  writeTexel(a + b);
})";
constexpr double kFlopsPerTurn = 8 * 8 * 2;

// MEETS stands for the test. Three additions a test vary the box.
constexpr const char* kBoxTests = R"(
#define STEP box += change; met += MEETS ? 1.0 : 0.0;
void main() {
  vec3 pixel = pixelCenter().xyx;
  GridRay ray = GridRay(vec3(0.01, 0.02, 0.03) + 1.0e-6 * pixel, vec3(-9.0, -18.0, -27.0));
  vec3 box = vec3(1000.0, 900.0, 800.0) + NODE_GRID * vec3(1100.0, 1000.0, 900.0);
  vec3 change = vec3(1.0) + uZero.xyz;
  float far = 1.0e6 + uZero.w;
  float met = 0.0;
  for (int i = 0; i < TURNS; i++) {
    STEP STEP STEP STEP STEP STEP STEP STEP
  }
  writeTexel(vec4(met));
})";

// Three additions a test vary the ray.
constexpr const char* kTriangleTests = R"(
#define DISTANCE intersectTriangle(origin, direction, v0, v1, v2, far).t
#define STEP origin += change; sum += DISTANCE;
void main() {
  vec3 origin = vec3(1.0e-3 * pixelCenter(), -2.0);
  vec3 direction = vec3(0.1, 0.2, 1.0) + uZero.xyz;
  vec3 change = vec3(1.0e-5) + uZero.xyz;
  vec3 v0 = vec3(0.0, 0.0, 1.0) + uZero.xyz;
  vec3 v1 = vec3(2.0, 0.1, 1.1) + uZero.xyz;
  vec3 v2 = vec3(0.1, 2.0, 1.2) + uZero.xyz;
  float far = 1.0e6 + uZero.w;
  float sum = 0.0;
  for (int i = 0; i < TURNS; i++) {
    STEP STEP STEP STEP STEP STEP STEP STEP
  }
  writeTexel(vec4(sum));
})";

// START and MOVE say where a pixel begins and how far it goes on each turn, AT(k) where fetch k is
// from there.
constexpr const char* kIndependentFetches = R"(
uniform sampler2D uTexels;
uniform vec2 uTexelStep;
#define FETCH(k) sum += texture2D(uTexels, base + AT(k));
void main() {
  vec2 texel = uTexelStep;
  vec2 base = START;
  vec4 sum = vec4(0.0);
  for (int i = 0; i < TURNS; i++) {
    FETCH(0.0) FETCH(1.0) FETCH(2.0) FETCH(3.0) FETCH(4.0) FETCH(5.0) FETCH(6.0) FETCH(7.0)
    base = fract(base + MOVE);
  }
  writeTexel(sum);
})";

constexpr const char* kChain = R"(
uniform sampler2D uTexels;
uniform vec2 uTexelStep;
#define STEP texel = texture2D(uTexels, texel.xy); sum += texel.zw;
void main() {
  vec4 texel = texture2D(uTexels, pixelCenter() * uTexelStep);
  vec2 sum = vec2(0.0);
  for (int i = 0; i < TURNS; i++) {
    STEP STEP STEP STEP STEP STEP STEP STEP
  }
  writeTexel(vec4(sum, texel.xy));
})";

DeviceWork boxWork(const char* name, const char* traversal, const std::string& meets) {
  return {
      name, kTests, kStepsPerTurn, traversal, fmt::format("#define MEETS {}\n{}", meets, kBoxTests),
      0};
}

DeviceWork fetchWork(const std::string& name, std::size_t bytes, const std::string& macros) {
  return {name, kFetches, kStepsPerTurn, "", macros + kIndependentFetches, bytes};
}

std::string sizeText(std::size_t bytes) {
  return bytes < kMib ? fmt::format("{} KiB", bytes / kKib) : fmt::format("{} MiB", bytes / kMib);
}

}  // namespace

std::vector<DeviceWork> arithmeticWorks() {
  return {{kArithmeticWork, "GFLOP/s", kFlopsPerTurn, "", kMultiplyAdd, 0},
          boxWork(kBoxWork, "skip", "isMet(passageThrough(box, ray, far))"),
          boxWork(kOrderedBoxWork, "octant", "meetsBox(vec4(box, 1.0), ray, far)"),
          {kTriangleWork, kTests, kStepsPerTurn, "skip", kTriangleTests, 0}};
}

DeviceWork sameTexelWork() {
  return fetchWork("fetch, all the same texel", kSmallTexture, R"(
#define START (0.5 * texel + uZero.xy)
#define MOVE vec2(8.0, 1.0) * texel
#define AT(k) vec2(k, 0.0) * texel
)");
}

DeviceWork neighboursWork() {
  return fetchWork("fetch, neighbours in 1 MiB", kMib, R"(
#define START (pixelCenter() * texel)
#define MOVE vec2(8.0, 1.0) * texel
#define AT(k) vec2(k, 0.0) * texel
)");
}

// The texels themselves hold random places to start from. The steps have nothing to do with the
// size of the texture.
DeviceWork randomTexelsWork(std::size_t bytes) {
  return fetchWork("fetch, random in " + sizeText(bytes), bytes, R"(
#define START texture2D(uTexels, pixelCenter() * texel).xy
#define MOVE vec2(0.7548777, 0.5698403)
#define AT(k) vec2(0.6180340 * k, 0.4142136 * k)
)");
}

DeviceWork chainWork(std::size_t bytes) {
  return {"chain in " + sizeText(bytes), kFetches, kStepsPerTurn, "", kChain, bytes};
}

}  // namespace glimt
