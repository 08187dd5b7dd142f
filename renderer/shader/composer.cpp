#include "renderer/shader/composer.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <map>

#include "renderer/core/error.h"
#include "renderer/shader/branches.h"
#include "renderer/shader/embedded_files.h"
#include "renderer/shader/pieces.h"
#include "renderer/shader/records.h"
#include "renderer/shader/traversals.h"

namespace glimt {
namespace {

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
  return shaderText("luminance.glsl") + shaderText(std::string(kClamp));
}

std::string pieces(unsigned pass, const ShaderRequest& request) {
  const auto textOf = [&](std::string_view file) {
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
    return shaderText(std::string(file));
  };
  std::string text;
  for (const Piece& piece : shaderPieces()) {
    if (!(piece.passes & pass)) continue;
    if (!isMet(piece.condition, request.effects)) continue;
    text += textOf(piece.file);
  }
  return text;
}

}  // namespace

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
  for (const Piece& piece : shaderPieces()) {
    if (!(piece.passes & kCamera) || !isMet(piece.condition, {})) continue;
    if (piece.file == kTraversal) break;
    add(std::string(piece.file));
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
