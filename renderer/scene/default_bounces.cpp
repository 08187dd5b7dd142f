#include "renderer/scene/default_bounces.h"

#include <fmt/format.h>

#include <vector>

namespace glimt {

BounceLimit defaultBounces(const EffectSet& effects) {
  constexpr int kScattered = 4;
  constexpr int kSentOn = 8;
  std::vector<std::string> sending;
  for (const Effect effect : {Effect::mirror, Effect::glass, Effect::rough_glass})
    if (has(effects, effect)) sending.push_back(nameOf(effect));
  if (sending.empty()) return {kScattered, "no surface is a mirror or glass"};
  return {kSentOn, fmt::format("light that mirrors and glass send on is still strong: {}",
                               fmt::join(sending, ", "))};
}

}  // namespace glimt
