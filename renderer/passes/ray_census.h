// What the paths of a picture's first sample met: how much work a sample is, and where.
#pragma once

#include <string>
#include <vector>

#include "renderer/core/vector.h"

namespace glimt {

// Rays of the first sample.
struct RayCounts {
  double camera = 0;
  double bounce = 0;
  double shadow = 0;  // at most: one for each hit that asked for light
};

class RayCensus {
 public:
  void forget();

  // Whether all bounces have been counted.
  bool complete() const { return complete_; }

  // The hit records that a bounce has left, in turn from that of the camera, which is 0, to the
  // last one. `record` is their name, see records.h; of a record of several texels these are the
  // first.
  void count(const std::vector<Vec4>& records, const std::string& record, int bounce,
             int last_bounce);

  // Whether the bounce counted last has left no path: then the others have none, and it is
  // complete.
  bool endsEarly(int last_bounce);

  // Share of the paths that met a triangle at that bounce. Once it is complete.
  double alive(int bounce) const { return alive_[static_cast<std::size_t>(bounce)]; }

  const RayCounts& rays() const { return rays_; }

  // How many triangles each pixel's path met, rows from the bottom.
  const std::vector<float>& lengths() const { return lengths_; }

 private:
  bool complete_ = false;
  std::vector<double> alive_;
  RayCounts rays_;
  std::vector<float> lengths_;
};

}  // namespace glimt
