// What the limits of a picture cost: the parts of its error that no number of samples takes away.
#pragma once

#include "renderer/core/light_limits.h"
#include "renderer/renderer.h"

namespace glimt {

// Errors are those of the converged picture, relative as the noise is: see NoiseEstimate.
struct LimitError {
  double truncation = 0;   // light that the limit on bounces leaves out
  double clamp = 0;        // light that the clamp takes
  double both = 0;         // together, less than their sum where they are of different pixels
  double light = 0;        // of the mean luminance, the share that is lost to both
  int all_bounces = 0;     // limit above which there is hardly any light
  int enough_bounces = 0;  // limit that brings `truncation` below the noise, as far as is known
};

// Compares small pictures of the renderer's scene without the limits and with them, for about
// `seconds`. Since the pictures compared are of the same paths, few samples do; two independent
// pairs are multiplied, so that their noise does not count as an error. `noise` is the picture's.
// What the renderer has rendered is gone afterwards. Errors: failed, when GL fails.
LimitError measureLimits(Renderer& renderer, const RenderSettings& settings, double noise,
                         double seconds);

}  // namespace glimt
