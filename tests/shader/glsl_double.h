// The pure files of shaders/ in double precision: the yardstick of their rounding errors.
#pragma once

#include <glm/glm.hpp>

namespace glimt::glsl_double {

#include "tests/shader/all_effects.inc"
#include "tests/shader/glsl_names.inc"

using vec2 = glm::dvec2;
using vec3 = glm::dvec3;
using vec4 = glm::dvec4;

// The shaders' functions are not inline, so every file that includes this gets its own.
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wunused-function"
#define float double
namespace {
// A file comes after those that it calls.
// clang-format off
#include "shaders/constants.glsl"
#include "shaders/float_fields.glsl"
#include "shaders/octahedral.glsl"
#include "shaders/hit_record.glsl"
#include "shaders/triangle.glsl"
#include "shaders/frame.glsl"
#include "shaders/warp.glsl"
#include "shaders/lambert.glsl"
#include "shaders/ray_origin.glsl"
#include "shaders/shadow_terminator.glsl"
#include "shaders/multiple_importance.glsl"
#include "shaders/sample_mean.glsl"
#include "shaders/display_transform.glsl"
#include "shaders/tone_agx.glsl"
#include "shaders/tone_aces.glsl"
#include "shaders/texture_wrap.glsl"
#include "shaders/srgb_decoding.glsl"
#include "shaders/fresnel.glsl"
#include "shaders/ggx.glsl"
#include "shaders/gloss.glsl"
#include "shaders/mirror.glsl"
#include "shaders/glass.glsl"
#include "shaders/rough_glass.glsl"
#include "shaders/thin_wall.glsl"
#include "shaders/sheen.glsl"
#include "shaders/clearcoat.glsl"
#include "shaders/bsdf_sample.glsl"
#include "shaders/bsdf_layers.glsl"
#include "shaders/bsdf_layered.glsl"
// clang-format on
}  // namespace
#undef float
#pragma GCC diagnostic pop

}  // namespace glimt::glsl_double
