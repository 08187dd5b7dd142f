// How the noise of a picture fell, sample by sample.
#pragma once

#include <vector>

#include "renderer/core/noise_estimate.h"

namespace glimt {

class NoiseHistory {
 public:
  // Fewer samples than the time before begin another picture.
  void add(const NoiseEstimate& noise) {
    if (!points_.empty() && noise.samples < points_.back().samples) points_.clear();
    if (points_.empty() || noise.samples > points_.back().samples) points_.push_back(noise);
  }
  void clear() { points_.clear(); }
  const std::vector<NoiseEstimate>& points() const { return points_; }

 private:
  std::vector<NoiseEstimate> points_;
};

}  // namespace glimt
