// What the processor can do without GL: Embree's kernels on every hardware thread.
#pragma once

#include <vector>

#include "renderer/bench/bench_rays.h"
#include "renderer/bench/embree_scene.h"

namespace glimt {

class EmbreeCeiling {
 public:
  explicit EmbreeCeiling(const Scene& scene);

  double buildSeconds() const { return build_seconds_; }

  // One number a ray, as in TraversalProgram::run.
  std::vector<float> closestHits(const Rays& rays) const;
  std::vector<float> visibilities(const Rays& rays) const;

 private:
  double build_seconds_ = 0;
  EmbreeScene scene_;
};

}  // namespace glimt
