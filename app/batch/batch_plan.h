// The pictures of a job, and what they are called.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "app/batch/batch_job.h"
#include "renderer/scene/scene.h"

namespace glimt {

struct BatchPicture {
  std::string stem;             // of its files' names, "street_030_512x512"
  std::string variant;          // empty: the scene as it is
  std::string camera;           // empty: the scene's
  std::optional<double> angle;  // of the turntable, degrees from 0 to 360
  std::array<int, 2> size{};
};

// Variant by variant, in these the views (cameras, then angles), and of each the sizes: what
// follows each other shares as much as possible. Errors: input, for a variant or a camera
// that the scene does not have, and where two pictures would have the same name.
std::vector<BatchPicture> planOf(const BatchJob& job, const Scene& scene);

// Those that process `part` of `parts` makes, from 1 to `parts`: the same number for each but for
// one, side by side.
std::vector<BatchPicture> partOf(const std::vector<BatchPicture>& plan, int part, int parts);

// A camera on a turntable: moved around the vertical through its target by so many degrees,
// counter-clockwise seen from above, and where `elevation` is given, raised or lowered to it at the
// same distance, upright.
Camera turned(const Camera& camera, double angle, const std::optional<float>& elevation);

}  // namespace glimt
