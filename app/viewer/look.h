// What of a scene can be changed while it is looked at, as a plain value.
#pragma once

#include <string>
#include <vector>

#include "renderer/scene/scene.h"

namespace glimt {

struct Look {
  std::string variant;              // of the file's materials; empty: as they are without
  std::vector<Material> materials;  // as many as the scene has, in its order
  float environment_strength = 1;
  float environment_rotation = 0;  // degrees
  int bounces = 4;
  float exposure = 0;  // EV
  Tone tone = Tone::srgb;

  bool operator==(const Look&) const = default;
};

// The scene's own.
Look lookOf(const Scene& scene, const std::string& variant, int bounces, float exposure, Tone tone);

// Whether light does the same in both: they differ at most in how it is displayed.
bool sameLight(const Look& a, const Look& b);

// Gives the scene's materials and environment the look. The materials are those of the variant.
void apply(const Look& look, Scene& scene);

}  // namespace glimt
