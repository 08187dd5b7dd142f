// What the processor can do without GL: Embree's kernels on every hardware thread.
#pragma once

#include <memory>
#include <vector>

#include "renderer/bench/bench_rays.h"
#include "renderer/scene/scene.h"

namespace glimt {

class EmbreeCeiling {
 public:
  explicit EmbreeCeiling(const Scene& scene);
  EmbreeCeiling(EmbreeCeiling&&) noexcept;
  ~EmbreeCeiling();

  double buildSeconds() const;

  // One number a ray, as in TraversalProgram::run.
  std::vector<float> closestHits(const Rays& rays) const;
  std::vector<float> visibilities(const Rays& rays) const;

 private:
  class State;
  std::unique_ptr<State> state_;
};

}  // namespace glimt
