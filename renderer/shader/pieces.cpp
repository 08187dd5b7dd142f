#include "renderer/shader/pieces.h"

#include <array>

namespace glimt {
namespace {

constexpr unsigned kEscape = bit(Pass::escape);
constexpr unsigned kLight = bit(Pass::light);
constexpr unsigned kGuide = bit(Pass::guide);
constexpr unsigned kTell = bit(Pass::first_hit) | kGuide;  // of what a path has met
// What the passes that tell of a hit do not call the compiler leaves out.
constexpr unsigned kBounces = kScatter | kLight | kTell | kWholePath;  // start from a hit record
constexpr unsigned kPaths = kCamera | kBounces;
constexpr unsigned kNoise = bit(Pass::keep) | bit(Pass::change);
constexpr unsigned kFilter = bit(Pass::neighbours) | bit(Pass::atrous);
constexpr unsigned kDenoiser = bit(Pass::prepare) | kFilter | bit(Pass::finish);
constexpr unsigned kMeans = bit(Pass::accumulate) | bit(Pass::close_block) | kNoise |
                            bit(Pass::prepare) | bit(Pass::finish) | bit(Pass::display);
constexpr unsigned kArrivals = kLight | kWholePath;  // ask for the light at a hit

constexpr unsigned bit(Effect effect) {
  return 1u << static_cast<unsigned>(effect);
}
constexpr Condition with(unsigned effects) {
  return {effects, 0};
}
constexpr Condition with(Effect effect) {
  return with(bit(effect));
}
constexpr Condition without(unsigned effects) {
  return {0, effects};
}

constexpr unsigned kReflecting = bit(Effect::gloss) | bit(Effect::mirror);
constexpr unsigned kTransmitting = bit(Effect::glass) | bit(Effect::rough_glass);
constexpr unsigned kTextured = bit(Effect::textures);
constexpr unsigned kVaried = kTextured | bit(Effect::vertex_colors);
constexpr unsigned kOver = bit(Effect::sheen) | bit(Effect::clearcoat);
constexpr unsigned kLayered = kReflecting | kTransmitting | kOver;  // more than Lambert surfaces
// What microfacets reflect, and of which surfaces the table is that says how much that is.
constexpr unsigned kGlossy = kReflecting | bit(Effect::clearcoat);
constexpr unsigned kRough = kGlossy | bit(Effect::rough_glass) | bit(Effect::thin_walls);
constexpr unsigned kTabulated = kRough | bit(Effect::sheen);

constexpr auto kPieces = std::to_array<Piece>({
    {"layout.h", kPaths | bit(Pass::change) | bit(Pass::accumulate), {}},
    {"picture.glsl",
     kPaths | kEscape | bit(Pass::accumulate) | bit(Pass::close_block) | bit(Pass::guide_sum) |
         kNoise | kDenoiser,
     {}},
    {"constants.glsl", kPaths | kEscape, {}},
    {"sample_points.glsl", kPaths, {}},
    {"float_fields.glsl", kPaths | kEscape, {}},
    {"octahedral.glsl", kPaths | kEscape, {}},
    {"hit_record.glsl", kPaths | kEscape, {}},
    {"triangle.glsl", kPaths, {}},
    {"frame.glsl", kBounces | kEscape, {}},
    {"warp.glsl", kBounces | kEscape, {}},
    {"warp.glsl", kCamera, with(Effect::lens)},
    {"lambert.glsl", kBounces | kEscape, {}},
    {"fresnel.glsl", kBounces, with(kLayered)},
    {"ggx.glsl", kBounces, with(kRough)},
    {"gloss.glsl", kBounces, with(kGlossy)},
    {"mirror.glsl", kBounces, with(kGlossy | kTransmitting)},
    {"glass.glsl", kBounces, with(Effect::glass)},
    {"rough_glass.glsl", kBounces, with(Effect::rough_glass)},
    {"thin_wall.glsl", kBounces, with(Effect::thin_walls)},
    {"sheen.glsl", kBounces, with(Effect::sheen)},
    {"clearcoat.glsl", kBounces, with(Effect::clearcoat)},
    {"bsdf_sample.glsl", kBounces, {}},
    {"bsdf_lambert.glsl", kBounces, without(kLayered)},
    {"bsdf_layers.glsl", kBounces, with(kLayered)},
    {"bsdf_layered.glsl", kBounces, with(kLayered)},
    {"ray_origin.glsl", kBounces, {}},
    {"multiple_importance.glsl", kBounces, {}},
    {"texel_address.glsl", kPaths, {}},
    {"triangle_data.glsl", kPaths, {}},
    {"material_data.glsl", kBounces, {}},
    {"texture_wrap.glsl", kBounces, with(kTextured)},
    {"srgb_decoding.glsl", kBounces, with(kTextured)},
    {"texture_data.glsl", kBounces, with(kTextured)},
    {"attribute_data.glsl", kBounces, with(kVaried)},
    {"normal_map.glsl", kBounces, with(Effect::normal_maps)},
    {"normal_data.glsl", kBounces, with(Effect::smooth_normals)},
    {"shadow_terminator.glsl", kBounces, with(Effect::smooth_normals)},
    {"surface.glsl", kBounces, {}},
    {"material_layer.glsl", kBounces, {}},
    {"plain_material.glsl", kBounces, without(kVaried)},
    {"textured_material.glsl", kBounces, with(kVaried)},
    {"gloss_albedo.glsl", kBounces, with(kTabulated)},
    {"lambert_data.glsl", kBounces, without(kLayered)},
    {"layered_data.glsl", kBounces, with(kLayered)},
    // The camera's rays ask for the materials only where they may pass them.
    {"material_data.glsl", kCamera, with(bit(Effect::alpha) | bit(Effect::absorption))},
    {"texture_wrap.glsl", kCamera, with(Effect::alpha)},
    {"srgb_decoding.glsl", kCamera, with(Effect::alpha)},
    {"texture_data.glsl", kCamera, with(Effect::alpha)},
    {"attribute_data.glsl", kCamera, with(Effect::alpha)},
    {"alpha.glsl", kPaths, with(Effect::alpha)},
    {"traversal.glsl", kPaths, {}},
    {"node_data.glsl", kPaths, {}},
    {kTraversal, kPaths, {}},
    {"camera.glsl", kCamera | kWholePath, {}},
    {"lens.glsl", kCamera | kWholePath, with(Effect::lens)},
    {"orthographic.glsl", kCamera | kWholePath, with(Effect::orthographic)},
    {"light_share.glsl", kBounces, {}},
    {"light_table.glsl", kArrivals, with(Effect::triangle_lights)},
    {"punctual_lights.glsl", kArrivals, with(Effect::punctual_lights)},
    {"environment.glsl", kBounces | kEscape,
     with(Effect::environment).butNot(bit(Effect::environment_map))},
    {"environment_map.glsl", kBounces | kEscape, with(Effect::environment_map)},
    {"light_sample.glsl", kArrivals, {}},
    {"reflection.glsl", kArrivals, {}},
    {"sample_light.glsl", kArrivals, without(bit(Effect::many_lights))},
    {"resample_light.glsl", kArrivals, with(Effect::many_lights)},
    {"radiance_target.glsl", kLight | kEscape, {}},
    {"seen_by_camera.glsl", kScatter | kLight | kEscape, with(Effect::transparent_background)},
    {"seen_by_camera.glsl", kGuide, {}},
    {"shadow_catcher.glsl", kScatter | kGuide | kLight, with(Effect::shadow_catcher)},
    {kRecordInput, kScatter | kEscape | kLight | kTell, {}},
    {kRecordOutput, kCamera | kScatter, {}},
    {"absorption.glsl", kCamera | kScatter | kWholePath, with(Effect::absorption)},
    {"trace.glsl", kCamera | kScatter | kWholePath, {}},
    {"roulette.glsl", kTrace, {}},
    {"trace_pass.glsl", kCamera | kTrace, {}},
    {"delta_pass.glsl", kDelta, {}},
    {"escape.glsl", kEscape | kWholePath, with(Effect::environment)},
    {"escape_pass.glsl", kEscape, {}},
    {"emitted_radiance.glsl", kArrivals | kGuide, {}},
    {"light.glsl", kArrivals, {}},
    {"luminance.glsl", kLight, with(Effect::shadow_catcher)},
    {"caught_light.glsl", kLight, with(Effect::shadow_catcher)},
    {"light_pass.glsl", kLight, {}},
    {"first_hit.glsl", bit(Pass::first_hit), {}},
    {"guide.glsl", kGuide, {}},
    {"guide_sum.glsl", bit(Pass::guide_sum), {}},
    {"whole_path.glsl", kWholePath, {}},
    {"sample_mean.glsl", kMeans, {}},
    {kAccumulated, bit(Pass::accumulate), {}},
    {kClamp, bit(Pass::accumulate), {}},
    {"accumulate.glsl", bit(Pass::accumulate), {}},
    {"close_block.glsl", bit(Pass::close_block), {}},
    {"luminance.glsl", kNoise | bit(Pass::prepare) | kFilter, {}},
    {"keep_luminance.glsl", bit(Pass::keep), {}},
    {"change.glsl", bit(Pass::change), {}},
    {"guides.glsl", kDenoiser, {}},
    {"guide_weight.glsl", kFilter, {}},
    {"denoise_prepare.glsl", bit(Pass::prepare), {}},
    {"neighbour_variance.glsl", bit(Pass::neighbours), {}},
    {"atrous.glsl", bit(Pass::atrous), {}},
    {"denoise_finish.glsl", bit(Pass::finish), {}},
    {"display_transform.glsl", bit(Pass::display), {}},
    {kTone, bit(Pass::display), {}},
    {"display.glsl", bit(Pass::display), {}},
});

}  // namespace

bool isMet(const Condition& condition, const EffectSet& effects) {
  const unsigned long on = effects.to_ulong();
  return (condition.any_of == 0 || (on & condition.any_of) != 0) && (on & condition.none_of) == 0;
}

std::span<const Piece> shaderPieces() {
  return kPieces;
}

}  // namespace glimt
