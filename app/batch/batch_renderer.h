// What the pictures of a batch are made with: it keeps what the next one can use.
#pragma once

#include <functional>
#include <optional>
#include <string>

#include "app/batch/batch_plan.h"
#include "app/sampling.h"
#include "renderer/renderer.h"

namespace glimt {

class BatchRenderer {
 public:
  // `job` outlives this.
  explicit BatchRenderer(const BatchJob& job) : job_(job) {}

  // The job's scene in that variant, with its own camera. Reads it unless it was the last one asked
  // for. Errors: as loadScene's.
  const Scene& sceneOf(const std::string& variant);

  // That scene with the picture's camera. Errors: as those of cameraOf, too.
  const Scene& sceneOf(const BatchPicture& picture);

  // How the picture is drawn.
  RenderSettings settingsOf(const BatchPicture& picture);

  // Draws with the context, tree and programs of the pictures before, as far as they fit.
  // `progress` as the Renderer's. Errors: as the Renderer's and sampleUntil's.
  Sampling render(const BatchPicture& picture, const Interrupt& interrupt,
                  const WorkProgress& progress, const SamplingListener& listener);

  // After a failure: the next picture begins with a context of its own.
  void forget();

 private:
  void prepare(const BatchPicture& picture, const WorkProgress& progress);

  const BatchJob& job_;
  std::optional<std::string> variant_;  // of scene_
  Scene scene_;
  Camera own_camera_;  // of the scene, before a picture's took its place
  std::optional<ContextHandle> context_;
  std::optional<Renderer> renderer_;
  std::string drawn_variant_;  // that the renderer has
};

}  // namespace glimt
