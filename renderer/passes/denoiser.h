// Takes noise out of a picture, for previews: docs/denoiser.md.
#pragma once

#include <optional>

#include "renderer/core/work_progress.h"
#include "renderer/gl/device.h"
#include "renderer/gl/program.h"
#include "renderer/passes/film.h"
#include "renderer/passes/guides.h"
#include "renderer/passes/path_tracer.h"

namespace glimt {

// Compiles its programs and makes its targets when a picture is denoised for the first time.
class Denoiser {
 public:
  explicit Denoiser(const gl::Device& device) : device_(&device), guides_(device) {}

  // Another picture begins.
  void restart() { guides_.restart(); }

  // The tracer's picture, which stays as it is, with less noise. To be called at a sample's start,
  // when there is one at least. The texture lasts until the next call; its fourth channel counts
  // the samples. `progress` may end it. Errors: as TargetPair's and gl::checkErrors'.
  const gl::Target& denoise(PathTracer& tracer, const WorkProgress& progress = {});

 private:
  void prepare(const Film& film);
  void drawLight(const PathTracer& tracer);
  void draw(gl::Program& program, Pass pass);

  const gl::Device* device_;
  Guides guides_;
  std::optional<gl::Program> prepare_;
  std::optional<gl::Program> neighbours_;
  std::optional<gl::Program> atrous_;
  std::optional<gl::Program> finish_;
  TargetPair light_;
};

}  // namespace glimt
