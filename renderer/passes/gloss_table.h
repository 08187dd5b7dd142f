// What rough surfaces reflect in all, as a table: see shaders/gloss_albedo.glsl.
#pragma once

#include <vector>

#include "renderer/core/effects.h"
#include "renderer/gl/device.h"

namespace glimt {

// The directional albedo of white GGX microfacets that reflect once. `cosine` in (0, 1] is that of
// the direction with the normal, `roughness` in [0, 1]. In x the part that goes with the
// reflectance at normal incidence in Schlick's Fresnel, in y that with the one at the horizon.
Vec2 glossAlbedoOf(double cosine, double roughness);

// GLOSS_TABLE_SIZE squared of them, rows of the same roughness: cosines go by the square of the
// column's number, roughness by the row's. In z, with_sheen, what sheen_albedo.h gives. Some
// milliseconds, and some tens with sheen.
std::vector<Vec4> glossTable(bool with_sheen);

// Of one texel where the effects do not call for the table.
gl::Texture makeGlossTexture(const gl::Device& device, const EffectSet& effects);

}  // namespace glimt
