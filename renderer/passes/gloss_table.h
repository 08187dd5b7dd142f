// What rough surfaces reflect in all, as a table: see shaders/gloss_albedo.glsl.
#pragma once

#include <vector>

#include "renderer/core/effects.h"
#include "renderer/gl/device.h"
#include "renderer/gl/texture.h"
#include "renderer/scene/scene.h"

namespace glimt {

// The directional albedo of white GGX microfacets that reflect once. `cosine` in (0, 1] is that of
// the direction with the normal, `roughness` in [0, 1]. In x the part that goes with the
// reflectance at normal incidence in Schlick's Fresnel, in y that with the one at the horizon.
Vec2 glossAlbedoOf(double cosine, double roughness);

// The directional albedo of a rough boundary between dielectrics that light meets once: what it
// reflects and lets through in all. `ior` is that of the far side against the near one.
double glassAlbedoOf(double cosine, double roughness, double ior);

// The indices of refraction of the scene's rough glass, for which there are squares in the table.
std::vector<float> tabulatedIors(const Scene& scene);

// Which of the squares is meant for a material of that index: 1 for the first of iors, 0 without
// any.
std::size_t squareOfIor(const std::vector<float>& iors, float ior);

// Squares of GLOSS_TABLE_SIZE, one upon the other, in rows of the same roughness: cosines go by the
// cube of the column's number, roughness by the power 3/2 of the row's. The first has glossAlbedoOf
// in x and y and, with_sheen, what sheen_albedo.h gives in z; the others glassAlbedoOf, entering in
// x and leaving in y. As many more as make a power of two are empty. Each takes some 20
// milliseconds, sheen some more.
std::vector<Vec4> glossTable(bool with_sheen, const std::vector<float>& iors);

// What the table of a scene is made of.
struct GlossContents {
  bool needed = false;  // whether any of the effects calls for it
  bool with_sheen = false;
  std::vector<float> iors;

  bool operator==(const GlossContents&) const = default;
};
GlossContents glossContentsOf(const Scene& scene, const EffectSet& effects);

// Of one texel where it is not needed.
gl::Texture makeGlossTexture(const gl::Device& device, const GlossContents& contents);

}  // namespace glimt
