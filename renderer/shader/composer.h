// Writes the fragment shader of a pass from the files in shaders/: those that the pass needs, and
// of these only what the scene's effects call for.
#pragma once

#include <string>
#include <vector>

#include "renderer/core/effects.h"

namespace glimt {

enum class Pass {
  camera,      // camera ray -> hit record
  trace,       // hit record -> next hit record
  light,       // hit record -> radiance
  accumulate,  // radiance -> mean
  display,     // mean -> display values
};

struct ShaderRequest {
  Pass pass = Pass::display;
  EffectSet effects;
  std::string traversal = "octant";  // see traversals.h
  bool additive_blending = true;     // the light pass adds by blending, not by reading
};

// The name of a pass, for messages.
std::string nameOf(Pass pass);

// Vertex shader of every pass.
std::string composeVertexShader();

// Errors: usage, for a traversal that does not exist.
std::string composeFragmentShader(const ShaderRequest& request);

// A fragment shader from the prelude, the named files and some text of the caller's own: for probes
// of the device and of single functions. Errors: failed, for a file that does not exist.
std::string composeProbe(const std::vector<std::string>& files, const std::string& text);

// The same with a traversal and what it needs: the text calls closestHit and visibility. Errors:
// usage, for a traversal that does not exist.
std::string composeTraversalProbe(const std::string& traversal, const std::string& text);

// The same with all that the effects call for from the camera to the radiance: the text calls the
// functions of whole_path.glsl. Errors: usage, for a traversal that does not exist.
std::string composePathProbe(const EffectSet& effects, const std::string& traversal,
                             const std::string& text);

// The text of a file in shaders/. Errors: failed, if there is none of that name.
std::string shaderText(const std::string& file);

}  // namespace glimt
