#include "app/sampling.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <exception>
#include <limits>
#include <new>
#include <string>

#include "app/safe_picture.h"
#include "app/stopwatch.h"
#include "renderer/core/wording.h"

namespace glimt {
namespace {

// How long an interrupt waits for an answer, about.
constexpr double kChunk = 0.1;

constexpr int kDefaultSamples = 256;

constexpr int kUnlimited = std::numeric_limits<int>::max();

std::optional<EndedBy> limitMet(const Limits& limits, const Sampling& done) {
  if (done.samples == 0) return std::nullopt;
  if (limits.samples && done.samples >= *limits.samples) return EndedBy::samples;
  if (limits.seconds && done.seconds >= *limits.seconds) return EndedBy::time;
  if (limits.noise && done.noise && done.noise->upper <= *limits.noise) return EndedBy::noise;
  return std::nullopt;
}

// How long a sample takes at present: less and less where parts of the picture come to rest.
class SampleTime {
 public:
  void add(int samples, double seconds) {
    if (samples == samples_ || seconds < seconds_ + kWindow) return;
    of_sample_ = (seconds - seconds_) / (samples - samples_);
    samples_ = samples;
    seconds_ = seconds;
  }

  double ofSample(const Sampling& done) const {
    return of_sample_ > 0 ? of_sample_ : done.seconds / done.samples;
  }

 private:
  static constexpr double kWindow = 2;  // seconds

  int samples_ = 0;
  double seconds_ = 0;
  double of_sample_ = 0;
};

std::string describe(const std::exception& error) {
  return dynamic_cast<const std::bad_alloc*>(&error) ? "out of memory" : error.what();
}

// Samples until a limit is met or the user has had enough.
void sample(Renderer& renderer, const Limits& limits, const Interrupt& interrupt,
            const SamplingListener& listener, SafePicture& safe, Sampling& done) {
  const Stopwatch clock;
  SampleTime time;
  std::optional<EndedBy> end;
  while (!end) {
    if (interrupt.requested()) {
      end = EndedBy::interrupt;
      break;
    }
    // The first sample is timed by itself.
    renderer.advance(kChunk, done.samples == 0 ? 1 : limits.samples.value_or(kUnlimited));
    done.seconds = clock.seconds();
    if (done.samples == 0) done.first_sample = done.seconds;
    done.samples = renderer.samples();
    done.noise = renderer.noise();
    time.add(done.samples, done.seconds);
    end = limitMet(limits, done);
    done.seconds_per_sample = time.ofSample(done);
    listener(done);
    safe.keepWhenDue();
  }
  done.ended_by = *end;
  safe.keep();
  done.noise = renderer.noiseNow();
}

}  // namespace

Limits orDefault(Limits limits) {
  if (!limits.samples && !limits.seconds && !limits.noise) limits.samples = kDefaultSamples;
  return limits;
}

std::optional<double> secondsLeft(const Limits& limits, const Sampling& done) {
  if (done.samples == 0) return std::nullopt;
  std::optional<double> left;
  const auto atMost = [&](double seconds) {
    left = std::max(std::min(left.value_or(seconds), seconds), 0.0);
  };
  if (limits.samples) atMost((*limits.samples - done.samples) * done.seconds_per_sample);
  if (limits.seconds) atMost(*limits.seconds - done.seconds);
  if (limits.noise && done.noise) {
    const double wanted = done.noise->samplesFor(*limits.noise);
    if (std::isfinite(wanted)) atMost((wanted - done.samples) * done.seconds_per_sample);
  }
  return left;
}

std::string describe(const Limits& limits, const Sampling& done) {
  if (done.samples == 0) return fmt::format("first sample, {}", duration(done.seconds));
  std::string line = fmt::format("{}{} samples, {:.3g} samples/s", done.samples,
                                 limits.samples ? fmt::format(" of {}", *limits.samples) : "",
                                 1 / done.seconds_per_sample);
  if (done.noise) line += ", noise " + percent(done.noise->relative);
  if (limits.noise) line += " of " + percent(*limits.noise);
  return line;
}

Sampling sampleUntil(Renderer& renderer, const Limits& limits, const Interrupt& interrupt,
                     Progress& progress, double seconds_at_risk) {
  const auto show = [&](const Sampling& done) {
    if (!progress.due()) return;
    const std::optional<double> left = secondsLeft(limits, done);
    progress.show(left ? fmt::format("{}, {} left", describe(limits, done), duration(*left))
                       : describe(limits, done));
  };
  return sampleUntil(renderer, limits, interrupt, show, seconds_at_risk);
}

Sampling sampleUntil(Renderer& renderer, const Limits& limits, const Interrupt& interrupt,
                     const SamplingListener& listener, double seconds_at_risk) {
  Sampling done;
  SafePicture safe(renderer, seconds_at_risk);
  try {
    sample(renderer, limits, interrupt, listener, safe, done);
  } catch (const std::exception& error) {
    safe.rescue();
    if (safe.get().samples == 0) throw;
    done.samples = renderer.samples();
    done.ended_by = EndedBy::failure;
    done.failure = describe(error);
  }
  done.picture = safe.get();
  return done;
}

}  // namespace glimt
