// What the denoiser knows of a picture beside its light: which surfaces it shows.
#pragma once

#include <array>
#include <optional>

#include "renderer/core/work_progress.h"
#include "renderer/passes/film.h"
#include "renderer/passes/path_tracer.h"

namespace glimt {

// Sums over the first paths of each pixel, of what shaders/guide.glsl tells of them.
class Guides {
 public:
  explicit Guides(const gl::Device& device) : device_(&device) {}

  // Another picture begins.
  void restart() { rays_ = 0; }

  // Makes them those of the first `rays` paths; those that are there already stay. To be called at
  // a sample's start. `progress` may end it between two paths. Errors: as TargetPair's and
  // gl::checkErrors'.
  void extend(PathTracer& tracer, int rays, const WorkProgress& progress);

  // Hands them to a program that includes guides.glsl.
  void bind(gl::Program& program) const;

 private:
  void prepare(const Film& film);
  void add();

  const gl::Device* device_;
  std::optional<gl::Program> sum_;
  std::array<gl::Target, kGuides> path_;  // of one path
  std::array<TargetPair, kGuides> sums_;
  int rays_ = 0;
};

}  // namespace glimt
