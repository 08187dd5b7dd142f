// The effects that a scene can call for. What a scene does not call for is not compiled.
#pragma once

#include <array>
#include <bitset>
#include <string>

namespace glimt {

enum class Effect {
  triangle_lights,         // triangles that emit, sampled as lights
  environment,             // light from outside the scene
  environment_map,         // which differs from direction to direction
  smooth_normals,          // shading normals interpolated over a triangle
  gloss,                   // rough surfaces that reflect in a preferred direction
  mirror,                  // surfaces that reflect in one direction
  glass,                   // smooth boundaries that light passes
  rough_glass,             // rough ones
  thin_walls,              // those that do not bend it
  absorption,              // on the way through the inside of a material
  clearcoat,               // a clear boundary over the others
  sheen,                   // fibres over the others
  textures,                // pictures on surfaces
  emission_textures,       // on surfaces that emit
  normal_maps,             // which bend the shading normal
  vertex_colors,           // which multiply the base colour
  alpha,                   // surfaces with holes, or that let a share of the light pass
  unlit,                   // surfaces that show their base colour as it is
  punctual_lights,         // points, spots and directions that light comes from
  many_lights,             // so many places that light comes from that it pays to choose well
  lens,                    // a camera that is sharp at one distance
  orthographic,            // a camera whose rays are parallel
  transparent_background,  // the camera sees no light from outside the scene, and the picture has
                           // an alpha
  shadow_catcher,          // surfaces of which it sees the shadows on them alone
};

inline constexpr int kEffectCount = 24;

using EffectSet = std::bitset<kEffectCount>;

inline bool has(const EffectSet& effects, Effect effect) {
  return effects[static_cast<std::size_t>(effect)];
}

// As the command line and, in capitals, the shaders call it.
inline std::string nameOf(Effect effect) {
  constexpr std::array<const char*, kEffectCount> kNames{"triangle_lights",
                                                         "environment",
                                                         "environment_map",
                                                         "smooth_normals",
                                                         "gloss",
                                                         "mirror",
                                                         "glass",
                                                         "rough_glass",
                                                         "thin_walls",
                                                         "absorption",
                                                         "clearcoat",
                                                         "sheen",
                                                         "textures",
                                                         "emission_textures",
                                                         "normal_maps",
                                                         "vertex_colors",
                                                         "alpha",
                                                         "unlit",
                                                         "punctual_lights",
                                                         "many_lights",
                                                         "lens",
                                                         "orthographic",
                                                         "transparent_background",
                                                         "shadow_catcher"};
  return kNames[static_cast<std::size_t>(effect)];
}

}  // namespace glimt
