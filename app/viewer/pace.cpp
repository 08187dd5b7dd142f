#include "app/viewer/pace.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace glimt {
namespace {

// Pictures farther apart than this many seconds are not of one movement.
constexpr double kPause = 0.5;

// So many of the latest are what the window is like now.
constexpr std::ptrdiff_t kLatest = 20;

}  // namespace

void Pace::asked(std::uint64_t serial, double age) {
  waiting_.push_back({serial, clock_.seconds() - age});
}

void Pace::shown(std::uint64_t serial) {
  const double now = clock_.seconds();
  bool answers = false;
  while (!waiting_.empty() && waiting_.front().serial <= serial) {
    latencies_.push_back(now - waiting_.front().since);
    waiting_.pop_front();
    answers = true;
  }
  if (!answers) return;
  if (last_answer_ >= 0 && now - last_answer_ < kPause) intervals_.push_back(now - last_answer_);
  last_answer_ = now;
}

double Pace::framesPerSecond() const {
  const auto count = std::min(kLatest, static_cast<std::ptrdiff_t>(intervals_.size()));
  const double sum = std::accumulate(intervals_.end() - count, intervals_.end(), 0.0);
  return sum > 0 ? static_cast<double>(count) / sum : 0;
}

double quantile(std::vector<double> values, double share) {
  if (values.empty()) return 0;
  std::sort(values.begin(), values.end());
  return values[static_cast<std::size_t>(
      std::lround(share * static_cast<double>(values.size() - 1)))];
}

}  // namespace glimt
