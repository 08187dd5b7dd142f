// Work on a scene beside the window: with a context and a renderer of its own, on any thread.
#pragma once

#include <array>
#include <filesystem>
#include <map>
#include <string>

#include "app/viewer/window_picture.h"
#include "renderer/limit_error.h"

namespace glimt {

// A picture that is made without being looked at.
struct BesidePicture {
  View view;
  Camera camera;
  RenderSettings settings;  // its size; the bounces are the look's
  int gles = 2;
};

// Renders so many samples and writes the file. Errors: those of the renderer and of writing.
void renderToFile(const BesidePicture& picture, int samples, const std::filesystem::path& file,
                  const WorkProgress& progress);

// See renderer/limit_error.h. Errors: those of the renderer.
LimitError measureLimitsOf(const BesidePicture& picture, double noise,
                           const WorkProgress& progress);

// Of the time that a sample takes, the share that it would not without an effect that the scene
// calls for: by the effect's name. What is on without being here cannot be left out.
using EffectCosts = std::map<std::string, double>;

// From small pictures; see renderer/bench.h. Errors: those of the renderer.
EffectCosts effectCostsOf(const BesidePicture& picture, const WorkProgress& progress);

}  // namespace glimt
