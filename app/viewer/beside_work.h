// Work on a scene beside the window: with a context and a renderer of its own, on any thread.
#pragma once

#include <array>
#include <filesystem>

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

}  // namespace glimt
