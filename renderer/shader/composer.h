// Writes the fragment shader of a pass from the files in shaders/: those that the pass needs, and
// of these only what the scene's effects call for.
#pragma once

#include <string>
#include <vector>

#include "renderer/core/effects.h"
#include "renderer/core/tone.h"
#include "renderer/shader/pass.h"

namespace glimt {

// What of a sample the accumulate pass sums.
enum class Accumulated {
  radiance,
  seen_radiance,  // of what the camera sees over a transparent background
  coverage,       // what it sees of it; see coverage.glsl
  square,         // of the luminance of what it sees
  path_length,    // surfaces that its path has met; not over a transparent background
};

struct ShaderRequest {
  Pass pass = Pass::display;
  EffectSet effects;
  std::string traversal = "octant";  // see traversals.h
  std::string record = "packed";     // see records.h
  bool additive_blending = true;     // radiance is added by blending, not by reading
  Tone tone = Tone::srgb;            // of the display pass
  Accumulated accumulated = Accumulated::radiance;
  bool path_length = false;  // the light pass counts surfaces; see path_length.glsl
  bool clamp = false;        // bright samples are dimmed; of the accumulate pass
  bool live_only = false;    // draws are limited to live paths; see escape_pass.glsl
  int gles = 2;              // the OpenGL ES version whose language it is written in
};

// Vertex shader of every pass, in the language that the fragment shader is in.
std::string composeVertexShader(int gles = 2);

// Errors: usage, for a traversal or a record that does not exist.
std::string composeFragmentShader(const ShaderRequest& request);

// The same for a pass that depends on nothing but itself: accumulate, close_block, guide_sum, keep,
// change, prepare, neighbours, atrous, finish, display.
std::string composeFragmentShader(Pass pass);

// A fragment shader from the prelude, the named files and some text of the caller's own: for probes
// of the device and of single functions. Errors: failed, for a file that does not exist.
std::string composeProbe(const std::vector<std::string>& files, const std::string& text);

// Text that follows a file, where that is part of the shader.
struct Insertion {
  std::string file;
  std::string text;
};

// The same with a traversal and what it needs, in the language of the version that it is for: the
// text calls closestHit and visibility. Insertions may define macros for the files behind them.
// Errors: usage, for a traversal that does not exist.
std::string composeTraversalProbe(const std::string& traversal, const std::string& text,
                                  const std::vector<Insertion>& insertions = {});

// The same with all that the effects call for from the camera to the radiance: the text calls the
// functions of whole_path.glsl. Errors: usage, for a traversal that does not exist.
std::string composePathProbe(const EffectSet& effects, const std::string& traversal,
                             const std::string& text);

// The text of a file in shaders/. Errors: failed, if there is none of that name.
std::string shaderText(const std::string& file);

}  // namespace glimt
