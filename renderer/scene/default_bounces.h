// How many bounces a picture takes where nobody says.
#pragma once

#include <string>

#include "renderer/core/effects.h"

namespace glimt {

struct BounceLimit {
  int bounces = 0;     // secondary bounces
  std::string reason;  // "rough_glass: light passes several surfaces"
};

// What the effects call for. Light that is scattered at every surface is weak after few bounces;
// what mirrors send on, and what passes glass, is not, and a glass takes up four surfaces.
// docs/effects.md has the light that is lost beyond.
BounceLimit defaultBounces(const EffectSet& effects);

}  // namespace glimt
