// How many bounces a picture takes where neither the command line nor the scene's file says so.
#pragma once

#include <string>

#include "renderer/core/effects.h"

namespace glimt {

struct BounceLimit {
  int bounces = 0;     // secondary bounces
  std::string reason;  // why so many: "no surface is a mirror or glass"
};

// Four, or eight where mirrors or glass take up bounces and hardly weaken the light: then what is
// lost beyond shows no more in them than it does elsewhere; docs/effects.md has the measurements.
// Light that passes by alpha takes up no bounce.
BounceLimit defaultBounces(const EffectSet& effects);

}  // namespace glimt
