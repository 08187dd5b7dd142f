#include "renderer/shader/composer.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <optional>

#include "renderer/core/error.h"
#include "renderer/shader/embedded_files.h"
#include "renderer/shader/traversals.h"

namespace glimt {
namespace {

// Which passes a file is part of.
constexpr unsigned bit(Pass pass) {
  return 1u << static_cast<unsigned>(pass);
}
constexpr unsigned kCamera = bit(Pass::camera);
constexpr unsigned kTrace = bit(Pass::trace);
constexpr unsigned kLight = bit(Pass::light);
constexpr unsigned kWholePath = bit(Pass::display) << 1;  // no pass; see composePathProbe
constexpr unsigned kPaths = kCamera | kTrace | kLight | kWholePath;
constexpr unsigned kBounces = kTrace | kLight | kWholePath;  // start from a hit record
constexpr unsigned kArrivals = kLight | kWholePath;          // ask for the light at a hit

struct Piece {
  const char* file;
  unsigned passes;
  std::optional<Effect> effect;  // left out where the scene does not call for it
};

// Stands for the files of the traversal that was asked for.
constexpr const char* kTraversal = "traverse_*.glsl";

// In the order in which they are put together: a file comes after those that it calls.
const auto kPieces = std::to_array<Piece>({
    {"layout.h", kPaths, {}},
    {"picture.glsl", kPaths | bit(Pass::accumulate), {}},
    {"constants.glsl", kPaths, {}},
    {"sample_points.glsl", kPaths, {}},
    {"float_fields.glsl", kPaths, {}},
    {"octahedral.glsl", kPaths, {}},
    {"hit_record.glsl", kPaths, {}},
    {"triangle.glsl", kPaths, {}},
    {"frame.glsl", kBounces, {}},
    {"warp.glsl", kBounces, {}},
    {"lambert.glsl", kBounces, {}},
    {"ray_origin.glsl", kBounces, {}},
    {"multiple_importance.glsl", kBounces, {}},
    {"texel_address.glsl", kPaths, {}},
    {"triangle_data.glsl", kPaths, {}},
    {"material_data.glsl", kBounces, {}},
    {"normal_data.glsl", kBounces, Effect::smooth_normals},
    {"surface.glsl", kBounces, {}},
    {"traversal.glsl", kPaths, {}},
    {"node_data.glsl", kPaths, {}},
    {kTraversal, kPaths, {}},
    {"camera.glsl", kCamera | kWholePath, {}},
    {"light_share.glsl", kBounces, {}},
    {"light_table.glsl", kArrivals, Effect::triangle_lights},
    {"environment.glsl", kArrivals, Effect::environment},
    {"light_sample.glsl", kArrivals, {}},
    {"trace.glsl", kCamera | kTrace | kWholePath, {}},
    {"trace_pass.glsl", kCamera | kTrace, {}},
    {"light.glsl", kArrivals, {}},
    {"light_pass.glsl", kLight, {}},
    {"whole_path.glsl", kWholePath, {}},
    {"accumulate.glsl", bit(Pass::accumulate), {}},
    {"display_transform.glsl", bit(Pass::display), {}},
    {"display.glsl", bit(Pass::display), {}},
});

std::string traversalText(const std::string& name) {
  std::string text;
  for (const std::string& file : traversalNamed(name).files) text += shaderText(file);
  return text;
}

// What the files are told of the pass and, in `effects`, of the scene. `#if NAME` needs every name
// defined, to 1 or to 0.
std::string defines(unsigned pass, const EffectSet& effects, bool additive_blending) {
  std::string text = fmt::format(
      "#define FROM_CAMERA {:d}\n#define FROM_RECORD {:d}\n#define ADDITIVE_BLENDING {:d}\n",
      (pass & (kCamera | kWholePath)) != 0, (pass & (kTrace | kWholePath)) != 0, additive_blending);
  for (int i = 0; i < kEffectCount; ++i) {
    std::string name = nameOf(static_cast<Effect>(i));
    std::transform(name.begin(), name.end(), name.begin(),
                   [](unsigned char c) { return static_cast<char>(std::toupper(c)); });
    text += fmt::format("#define {} {:d}\n", name, effects[static_cast<std::size_t>(i)]);
  }
  return text;
}

std::string pieces(unsigned pass, const EffectSet& effects, const std::string& traversal) {
  std::string text;
  for (const Piece& piece : kPieces) {
    if (!(piece.passes & pass)) continue;
    if (piece.effect && !has(effects, *piece.effect)) continue;
    text += piece.file == kTraversal ? traversalText(traversal) : shaderText(piece.file);
  }
  return text;
}

}  // namespace

std::string nameOf(Pass pass) {
  constexpr std::array kNames{"camera", "trace", "light", "accumulate", "display"};
  return kNames[static_cast<std::size_t>(pass)];
}

std::string shaderText(const std::string& file) {
  for (const EmbeddedFile& embedded : embeddedFiles())
    if (file == embedded.name) return embedded.text;
  throw Error(ErrorKind::failed, "there is no shader file '" + file + "'");
}

std::string composeVertexShader() {
  return "#version 100\n" + shaderText("full_screen.vert");
}

std::string composeFragmentShader(const ShaderRequest& request) {
  const unsigned pass = bit(request.pass);
  return "#version 100\n" + shaderText("prelude.glsl") +
         defines(pass, request.effects, request.additive_blending) +
         pieces(pass, request.effects, request.traversal);
}

std::string composeProbe(const std::vector<std::string>& files, const std::string& text) {
  std::string shader = "#version 100\n" + shaderText("prelude.glsl");
  for (const std::string& file : files) shader += shaderText(file);
  return shader + text;
}

std::string composeTraversalProbe(const std::string& traversal, const std::string& text) {
  std::string shader = "#version 100\n" + shaderText("prelude.glsl");
  for (const Piece& piece : kPieces) {
    if (!(piece.passes & kCamera)) continue;
    if (piece.file == kTraversal) break;
    shader += shaderText(piece.file);
  }
  return shader + traversalText(traversal) + text;
}

std::string composePathProbe(const EffectSet& effects, const std::string& traversal,
                             const std::string& text) {
  return "#version 100\n" + shaderText("prelude.glsl") + defines(kWholePath, effects, false) +
         pieces(kWholePath, effects, traversal) + text;
}

}  // namespace glimt
