#include "renderer/shader/composer.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <map>

#include "renderer/core/error.h"
#include "renderer/shader/branches.h"
#include "renderer/shader/embedded_files.h"
#include "renderer/shader/records.h"
#include "renderer/shader/traversals.h"

namespace glimt {
namespace {

// Which passes a file is part of.
constexpr unsigned bit(Pass pass) {
  return 1u << static_cast<unsigned>(pass);
}
constexpr unsigned kCamera = bit(Pass::camera);
constexpr unsigned kTrace = bit(Pass::trace);
constexpr unsigned kEscape = bit(Pass::escape);
constexpr unsigned kLight = bit(Pass::light);
constexpr unsigned kWholePath = bit(Pass::display) << 1;  // no pass; see composePathProbe
constexpr unsigned kDelta = bit(Pass::delta);
constexpr unsigned kScatter = kTrace | kDelta;  // from a hit record to the next
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

// When a file is part of a shader: where the scene calls for one of some effects, and for none of
// some others.
struct Condition {
  unsigned any_of = 0;  // a bit for each effect; 0: always
  unsigned none_of = 0;

  constexpr Condition butNot(unsigned effects) const { return {any_of, effects}; }
};
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
bool isMet(const Condition& condition, const EffectSet& effects) {
  const unsigned long on = effects.to_ulong();
  return (condition.any_of == 0 || (on & condition.any_of) != 0) && (on & condition.none_of) == 0;
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

struct Piece {
  const char* file;
  unsigned passes;
  Condition condition;
};

// Stands for the files of the traversal that was asked for.
constexpr const char* kTraversal = "traverse_*.glsl";

// Stand for the files of the record that was asked for.
constexpr const char* kRecordInput = "*_record_input.glsl";
constexpr const char* kRecordOutput = "*_record_output.glsl";

// Stands for what dims bright samples, where that was asked for.
constexpr const char* kClamp = "sample_clamp.glsl";

// Stands for what takes other than the radiance from a sample, where that was asked for.
constexpr const char* kAccumulated = "*_accumulated.glsl";

// Stands for the file of the tone that was asked for.
constexpr const char* kTone = "tone_*.glsl";

// In the order in which they are put together: a file comes after those that it calls.
const auto kPieces = std::to_array<Piece>({
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

std::string traversalText(const std::string& name) {
  std::string text;
  for (const std::string& file : traversalNamed(name).files) text += shaderText(file);
  return text;
}

// What a fragment shader begins with.
std::string startFor(int gles) {
  const std::string version =
      gles < 3 ? "#version 100\n" : "#version 300 es\n" + shaderText("es3.glsl");
  return version + shaderText("prelude.glsl");
}

// As the shaders' `#if`s call an effect.
std::string capitalsOf(Effect effect) {
  std::string name = nameOf(effect);
  std::transform(name.begin(), name.end(), name.begin(),
                 [](unsigned char c) { return static_cast<char>(std::toupper(c)); });
  return name;
}

// What the `#if`s of the files ask for.
std::map<std::string, bool> answers(unsigned pass, const ShaderRequest& request) {
  std::map<std::string, bool> values = {
      {"FROM_CAMERA", (pass & (kCamera | kWholePath)) != 0},
      {"FROM_RECORD", (pass & (kScatter | kWholePath)) != 0},
      {"ADDITIVE_BLENDING", request.additive_blending},
      {"LIVE_ONLY", request.live_only},
      {"CLAMP", request.clamp},
      {"PATH_LENGTH", request.path_length},
  };
  for (int i = 0; i < kEffectCount; ++i) {
    const auto effect = static_cast<Effect>(i);
    values[capitalsOf(effect)] = has(request.effects, effect);
  }
  return values;
}

// Probes write what they find, and add nothing.
const ShaderRequest kProbe = [] {
  ShaderRequest request;
  request.additive_blending = false;
  return request;
}();

struct ToneShader {
  const char* function;
  const char* file;  // "" where display_transform.glsl has it
};

ToneShader shaderOf(Tone tone) {
  switch (tone) {
    case Tone::agx:
      return {"displayAgx", "tone_agx.glsl"};
    case Tone::aces:
      return {"displayAces", "tone_aces.glsl"};
    case Tone::srgb:
      break;
  }
  return {"displayTransform", ""};
}

struct AccumulatedShader {
  const char* function;
  std::vector<std::string> files;
};

AccumulatedShader shaderOf(Accumulated accumulated) {
  switch (accumulated) {
    case Accumulated::seen_radiance:
      return {"seenRadiance", {"coverage.glsl"}};
    case Accumulated::coverage:
      return {"seenCoverage", {"coverage.glsl"}};
    case Accumulated::square:
      return {"luminanceSquare", {"luminance.glsl", "coverage.glsl", "square.glsl"}};
    case Accumulated::path_length:
      return {"pathLength", {"path_length.glsl"}};
    case Accumulated::radiance:
      break;
  }
  return {"vec3", {}};
}

std::string clampText() {
  return shaderText("luminance.glsl") + shaderText(kClamp);
}

std::string pieces(unsigned pass, const ShaderRequest& request) {
  const auto textOf = [&](const char* file) {
    const ToneShader tone = shaderOf(request.tone);
    if (file == kTraversal) return traversalText(request.traversal);
    if (file == kClamp) return request.clamp ? clampText() : "";
    if (file == kAccumulated) {
      std::string text;
      for (const std::string& part : shaderOf(request.accumulated).files) text += shaderText(part);
      return text;
    }
    if (file == kTone) return *tone.file ? shaderText(tone.file) : "";
    if (file == kRecordInput) return shaderText(recordNamed(request.record).input_file);
    if (file == kRecordOutput) return shaderText(recordNamed(request.record).output_file);
    return shaderText(file);
  };
  std::string text;
  for (const Piece& piece : kPieces) {
    if (!(piece.passes & pass)) continue;
    if (!isMet(piece.condition, request.effects)) continue;
    text += textOf(piece.file);
  }
  return text;
}

}  // namespace

std::string nameOf(Pass pass) {
  constexpr std::array kNames{"camera",      "trace",     "escape",  "light",      "accumulate",
                              "close block", "first hit", "delta",   "guide",      "guide sum",
                              "keep",        "change",    "prepare", "neighbours", "atrous",
                              "finish",      "display"};
  static_assert(kNames.size() == kPassCount);
  return kNames[static_cast<std::size_t>(pass)];
}

std::string shaderText(const std::string& file) {
  for (const EmbeddedFile& embedded : embeddedFiles())
    if (file == embedded.name) return embedded.text;
  throw Error(ErrorKind::failed, "there is no shader file '" + file + "'");
}

std::string composeVertexShader(int gles) {
  const std::string start =
      gles < 3 ? "#version 100\n" : "#version 300 es\n" + shaderText("es3.vert");
  return start + shaderText("full_screen.vert");
}

std::string composeFragmentShader(const ShaderRequest& request) {
  const unsigned pass = bit(request.pass);
  std::string chosen;
  if (request.pass == Pass::display)
    chosen = fmt::format("#define DISPLAY_TRANSFORM {}\n", shaderOf(request.tone).function);
  if (request.pass == Pass::accumulate)
    chosen = fmt::format("#define ACCUMULATED {}\n", shaderOf(request.accumulated).function);
  return startFor(request.gles) + chosen +
         takeBranches(pieces(pass, request), answers(pass, request));
}

std::string composeFragmentShader(Pass pass) {
  ShaderRequest request;
  request.pass = pass;
  return composeFragmentShader(request);
}

std::string composeProbe(const std::vector<std::string>& files, const std::string& text) {
  std::string shader = startFor(2);
  const std::map<std::string, bool> values = answers(0, kProbe);
  for (const std::string& file : files) shader += takeBranches(shaderText(file), values);
  return shader + text;
}

std::string composeTraversalProbe(const std::string& traversal, const std::string& text,
                                  const std::vector<Insertion>& insertions) {
  std::string shader = startFor(traversalNamed(traversal).gles);
  const auto insertBehind = [&](const std::string& file) {
    for (const Insertion& insertion : insertions)
      if (insertion.file == file) shader += insertion.text;
  };
  const std::map<std::string, bool> values = answers(0, kProbe);
  const auto add = [&](const std::string& file) {
    shader += takeBranches(shaderText(file), values);
    insertBehind(file);
  };
  insertBehind("prelude.glsl");
  for (const Piece& piece : kPieces) {
    if (!(piece.passes & kCamera) || !isMet(piece.condition, {})) continue;
    if (piece.file == kTraversal) break;
    add(piece.file);
  }
  for (const std::string& file : traversalNamed(traversal).files) add(file);
  return shader + text;
}

std::string composePathProbe(const EffectSet& effects, const std::string& traversal,
                             const std::string& text) {
  ShaderRequest request = kProbe;
  request.effects = effects;
  request.traversal = traversal;
  return startFor(traversalNamed(traversal).gles) +
         takeBranches(pieces(kWholePath, request), answers(kWholePath, request)) + text;
}

}  // namespace glimt
