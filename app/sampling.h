// The loop of an offscreen render: samples until a limit is met.
#pragma once

#include <optional>
#include <string>

#include "app/interrupt.h"
#include "app/progress.h"
#include "renderer/renderer.h"

namespace glimt {

// The first one met ends the render. At least one is set.
struct Limits {
  std::optional<int> samples;
  std::optional<double> seconds;
  std::optional<double> noise;  // as NoiseEstimate::upper
};

enum class EndedBy { samples, time, noise, interrupt, failure };

struct Sampling {
  int samples = 0;                     // that were completed
  double seconds = 0;                  // spent sampling
  double first_sample = 0;             // of them, until the first sample was complete
  std::optional<NoiseEstimate> noise;  // of the picture, where that is known
  EndedBy ended_by = EndedBy::samples;
  std::string failure;  // what went wrong and ended the sampling; empty for nothing
  Picture picture;      // of all the samples, or after a failure of as many as there are left
};

// How many seconds of work a lost context may cost.
constexpr double kSecondsAtRisk = 10;

// At least one sample is completed, whatever the time limit, unless interrupted before that. What
// fails after that comes back with the picture so far: the whole of it where GL still gives it,
// else as it was about `seconds_at_risk` ago. Errors: those of the renderer before the first
// sample.
Sampling sampleUntil(Renderer& renderer, const Limits& limits, const Interrupt& interrupt,
                     Progress& progress, double seconds_at_risk = kSecondsAtRisk);

}  // namespace glimt
