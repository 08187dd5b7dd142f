#include "renderer/passes/traversal_trial.h"

#include <algorithm>

namespace glimt {
namespace {

constexpr double kSecondsBefore = 2;

// Of each candidate: the first sample compiles and is not timed.
constexpr std::size_t kSamplesEach = 5;

// Less is a tie, which the first candidate wins.
constexpr double kLeastGain = 0.03;

// The least, since whatever disturbs a sample makes it longer.
double secondsOf(const std::vector<double>& samples) {
  return *std::min_element(samples.end() - (kSamplesEach - 1), samples.end());
}

}  // namespace

TraversalTrial::TraversalTrial(std::vector<std::string> candidates)
    : candidates_(std::move(candidates)), seconds_(candidates_.size()) {}

void TraversalTrial::add(double seconds) {
  if (candidates_.size() < 2 || !times_.empty()) return;
  seconds_[current_].push_back(seconds);
  spent_ += seconds;
  if (spent_ < kSecondsBefore || seconds_[current_].size() < kSamplesEach) return;
  if (++current_ == candidates_.size()) decide();
}

void TraversalTrial::decide() {
  current_ = 0;
  for (std::size_t i = 0; i < candidates_.size(); ++i) {
    times_.push_back({candidates_[i], secondsOf(seconds_[i])});
    const double needed =
        times_[current_].seconds_per_sample * (current_ == 0 ? 1 - kLeastGain : 1);
    if (times_[i].seconds_per_sample < needed) current_ = i;
  }
}

void TraversalTrial::restart() {
  if (!times_.empty()) return;
  *this = TraversalTrial(std::move(candidates_));
}

}  // namespace glimt
