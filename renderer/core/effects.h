// The effects that a scene can call for. What a scene does not call for is not compiled.
#pragma once

#include <array>
#include <bitset>
#include <string>

namespace glimt {

enum class Effect {
  triangle_lights,  // triangles that emit, sampled as lights
  environment,      // light from outside the scene
  environment_map,  // which differs from direction to direction
  smooth_normals,   // shading normals interpolated over a triangle
  gloss,            // rough surfaces that reflect in a preferred direction
  mirror,           // surfaces that reflect in one direction
  glass,            // smooth boundaries that light passes
  rough_glass,      // rough ones
  thin_walls,       // those that do not bend it
  absorption,       // on the way through the inside of a material
  clearcoat,        // a clear boundary over the others
  sheen,            // fibres over the others
};

inline constexpr int kEffectCount = 12;

using EffectSet = std::bitset<kEffectCount>;

inline bool has(const EffectSet& effects, Effect effect) {
  return effects[static_cast<std::size_t>(effect)];
}

// As the command line and, in capitals, the shaders call it.
inline std::string nameOf(Effect effect) {
  constexpr std::array<const char*, kEffectCount> kNames{
      "triangle_lights", "environment", "environment_map", "smooth_normals", "gloss",     "mirror",
      "glass",           "rough_glass", "thin_walls",      "absorption",     "clearcoat", "sheen"};
  return kNames[static_cast<std::size_t>(effect)];
}

}  // namespace glimt
