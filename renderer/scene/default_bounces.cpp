#include "renderer/scene/default_bounces.h"

namespace glimt {

BounceLimit defaultBounces(const EffectSet& effects) {
  constexpr int kScattering = 4;
  constexpr int kMirrors = 8;
  constexpr int kPassing = 12;
  for (const Effect effect : {Effect::glass, Effect::rough_glass})
    if (has(effects, effect)) return {kPassing, nameOf(effect) + ": light passes several surfaces"};
  for (const Effect effect : {Effect::mirror, Effect::alpha})
    if (has(effects, effect)) return {kMirrors, nameOf(effect)};
  return {kScattering, "light is scattered at every surface"};
}

}  // namespace glimt
