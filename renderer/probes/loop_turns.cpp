#include "renderer/probes/loop_turns.h"

#include <algorithm>

namespace glimt {
namespace {

// The inner loop alone is as long as that of any traversal.
constexpr const char* kLoops = R"(
vec4 probe(vec4 wanted) {
  float turns = 0.0;
  for (int i = 0; i < 64; i++) {
    if (turns >= wanted.x) break;
    for (int k = 0; k < MAX_STEPS; k++) {
      if (turns >= wanted.x) break;
      turns += 1.0;
    }
  }
  return vec4(turns);
})";

// A device without a limit should not be kept busy for long by a first guess.
constexpr std::uint32_t kFirstGuess = 1u << 16;
constexpr std::uint32_t kGrowth = 4;

}  // namespace

LoopProbe::LoopProbe(const gl::Device& device) : probe_(device, {}, kLoops) {}

std::uint32_t LoopProbe::turns(std::uint32_t wanted) {
  constexpr int kOnePixel = 1;
  const Vec4 asked(static_cast<float>(std::min(wanted, kMostLoopTurns)));
  return static_cast<std::uint32_t>(probe_.run({{asked}}, {}, kOnePixel)[0].x);
}

std::optional<std::uint32_t> findLoopLimit(const gl::Device& device, std::uint32_t most) {
  LoopProbe probe(device);
  for (std::uint32_t wanted = std::min(kFirstGuess, most);;
       wanted = std::min(kGrowth * wanted, most)) {
    const std::uint32_t turns = probe.turns(wanted);
    if (turns < wanted) return turns;
    if (wanted == most) return std::nullopt;
  }
}

}  // namespace glimt
