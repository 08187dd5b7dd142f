#include "renderer/probes/number_probes.h"

#include <cmath>
#include <random>

#include "renderer/probes/probe.h"

namespace glimt {
namespace {

constexpr std::size_t kDrawn = std::size_t{1} << 20;  // texels in one draw
constexpr const char* kPass = "vec4 probe(vec4 a) { return a; }";

// 24 bits at most, as many small ones as large ones.
float randomInteger(std::mt19937& random) {
  const auto bits = static_cast<std::uint32_t>(random());
  const auto integer = static_cast<float>(bits >> (8 + random() % 24));
  return random() % 2 ? integer : -integer;
}

}  // namespace

std::vector<Vec4> scaledIntegers(std::size_t count) {
  std::mt19937 random(30);
  std::vector<Vec4> texels{Vec4(16777215, 16777213, -16777215, 2049), Vec4(0, -1, 1e-30f, 1e30f)};
  texels.resize(count);
  for (std::size_t i = 2; i < count; ++i)
    for (int channel = 0; channel < 4; ++channel)
      texels[i][channel] = std::ldexp(randomInteger(random), static_cast<int>(random() % 121) - 60);
  return texels;
}

std::size_t countDifferent(const std::vector<Vec4>& is, const std::vector<Vec4>& expected) {
  std::size_t count = 0;
  for (std::size_t i = 0; i < expected.size(); ++i) count += is[i] != expected[i];
  return count;
}

NumbersProbe probeAllIntegers(const gl::Device& device) {
  Probe probe(device, {}, kPass);
  std::vector<Vec4> texels(kDrawn);
  NumbersProbe found;
  for (std::size_t first = 0; first < std::size_t{1} << 23; first += kDrawn) {
    for (std::size_t i = 0; i < kDrawn; ++i) {
      const auto even = static_cast<float>(2 * (first + i));
      texels[i] = Vec4(even, even + 1, -even, -even - 1);
    }
    found.texels += kDrawn;
    found.wrong += countDifferent(probe.run({texels}), texels);
  }
  return found;
}

NumbersProbe probeScaledIntegers(const gl::Device& device) {
  const std::vector<Vec4> texels = scaledIntegers(kDrawn);
  return {kDrawn, countDifferent(Probe(device, {}, kPass).run({texels}), texels)};
}

}  // namespace glimt
