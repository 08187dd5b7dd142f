// The loop of an offscreen render: samples until a limit is met.
#pragma once

#include <functional>
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

// The limits, or 256 samples where none is set.
Limits orDefault(Limits limits);

enum class EndedBy { samples, time, noise, interrupt, failure };

struct Sampling {
  int samples = 0;                     // that were completed
  double seconds = 0;                  // spent sampling
  double seconds_per_sample = 0;       // at present, less where parts of the picture rest
  double first_sample = 0;             // of them, until the first sample was complete
  std::optional<NoiseEstimate> noise;  // of the picture, where that is known
  EndedBy ended_by = EndedBy::samples;
  std::string failure;  // what went wrong and ended the sampling; empty for nothing
  Picture picture;      // of all the samples, or after a failure of as many as there are left
};

// How many seconds of work a lost context may cost.
constexpr double kSecondsAtRisk = 10;

// Nothing where only the noise ends the render and is not known yet.
std::optional<double> secondsLeft(const Limits& limits, const Sampling& done);

// For people: samples, noise and what they are of.
std::string describe(const Limits& limits, const Sampling& done);

// Told of the samples so far, many times a second; of it, Sampling::picture is not there yet.
using SamplingListener = std::function<void(const Sampling& done)>;

// At least one sample is completed, whatever the time limit, unless interrupted before that. What
// fails after that comes back with the picture so far: the whole of it where GL still gives it,
// else as it was about `seconds_at_risk` ago. Errors: those of the renderer before the first
// sample.
Sampling sampleUntil(Renderer& renderer, const Limits& limits, const Interrupt& interrupt,
                     const SamplingListener& listener, double seconds_at_risk = kSecondsAtRisk);

// The same with a line that says how far it is and how long it takes.
Sampling sampleUntil(Renderer& renderer, const Limits& limits, const Interrupt& interrupt,
                     Progress& progress, double seconds_at_risk = kSecondsAtRisk);

}  // namespace glimt
