#include "app/sampling.h"

#include <fmt/format.h>

#include <algorithm>
#include <exception>
#include <limits>
#include <new>
#include <string>

#include "app/safe_picture.h"
#include "app/stopwatch.h"

namespace glimt {
namespace {

// How long an interrupt waits for an answer, about.
constexpr double kChunk = 0.1;

constexpr int kUnlimited = std::numeric_limits<int>::max();

bool met(const Limits& limits, const Sampling& done) {
  return done.samples > 0 && ((limits.samples && done.samples >= *limits.samples) ||
                              (limits.seconds && done.seconds >= *limits.seconds));
}

double secondsLeft(const Limits& limits, const Sampling& done) {
  double left = std::numeric_limits<double>::infinity();
  if (limits.samples) left = (*limits.samples - done.samples) * done.seconds / done.samples;
  if (limits.seconds) left = std::min(left, *limits.seconds - done.seconds);
  return std::max(left, 0.0);
}

std::string duration(double seconds) {
  if (seconds < 100) return fmt::format("{:.0f} s", seconds);
  if (seconds < 100 * 60) return fmt::format("{:.0f} min", seconds / 60);
  return fmt::format("{:.1f} h", seconds / 3600);
}

std::string describe(const Limits& limits, const Sampling& done) {
  if (done.samples == 0) return fmt::format("first sample, {}", duration(done.seconds));
  const std::string goal = limits.samples ? fmt::format(" of {}", *limits.samples) : "";
  return fmt::format("{}{} samples, {:.3g} samples/s, {} left", done.samples, goal,
                     done.samples / done.seconds, duration(secondsLeft(limits, done)));
}

std::string describe(const std::exception& error) {
  return dynamic_cast<const std::bad_alloc*>(&error) ? "out of memory" : error.what();
}

// Samples until a limit is met or the user has had enough.
void sample(Renderer& renderer, const Limits& limits, const Interrupt& interrupt,
            Progress& progress, SafePicture& safe, Sampling& done) {
  const Stopwatch clock;
  while (!met(limits, done)) {
    done.interrupted = interrupt.requested();
    if (done.interrupted) break;
    // The first sample is timed by itself.
    renderer.advance(kChunk, done.samples == 0 ? 1 : limits.samples.value_or(kUnlimited));
    done.seconds = clock.seconds();
    if (done.samples == 0) done.first_sample = done.seconds;
    done.samples = renderer.samples();
    if (progress.due()) progress.show(describe(limits, done));
    safe.keepWhenDue();
  }
  safe.keep();
}

}  // namespace

Sampling sampleUntil(Renderer& renderer, const Limits& limits, const Interrupt& interrupt,
                     Progress& progress, double seconds_at_risk) {
  Sampling done;
  SafePicture safe(renderer, seconds_at_risk);
  try {
    sample(renderer, limits, interrupt, progress, safe, done);
  } catch (const std::exception& error) {
    safe.rescue();
    if (safe.get().samples == 0) throw;
    done.samples = renderer.samples();
    done.failure = describe(error);
  }
  done.picture = safe.get();
  return done;
}

}  // namespace glimt
