#include "app/sampling.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <string>

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

}  // namespace

Sampling sampleUntil(Renderer& renderer, const Limits& limits, const Interrupt& interrupt,
                     Progress& progress) {
  const Stopwatch clock;
  Sampling done;
  while (!met(limits, done)) {
    done.interrupted = interrupt.requested();
    if (done.interrupted) break;
    // The first sample is timed by itself.
    renderer.advance(kChunk, done.samples == 0 ? 1 : limits.samples.value_or(kUnlimited));
    done.seconds = clock.seconds();
    if (done.samples == 0) done.first_sample = done.seconds;
    done.samples = renderer.samples();
    if (progress.due()) progress.show(describe(limits, done));
  }
  return done;
}

}  // namespace glimt
