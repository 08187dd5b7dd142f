// The loop of an offscreen render: samples until a limit is met.
#pragma once

#include <optional>

#include "app/interrupt.h"
#include "app/progress.h"
#include "renderer/renderer.h"

namespace glimt {

// The first one met ends the render. At least one is set.
struct Limits {
  std::optional<int> samples;
  std::optional<double> seconds;
};

struct Sampling {
  int samples = 0;          // complete ones
  double seconds = 0;       // spent sampling
  double first_sample = 0;  // of them, until the first sample was complete
  bool interrupted = false;
};

// At least one sample is completed, whatever the time limit, unless interrupted before that.
Sampling sampleUntil(Renderer& renderer, const Limits& limits, const Interrupt& interrupt,
                     Progress& progress);

}  // namespace glimt
