// How fast the window answers: from an event to the picture that shows what it did.
#pragma once

#include <cstdint>
#include <deque>
#include <vector>

#include "app/stopwatch.h"

namespace glimt {

class Pace {
 public:
  // An event that is at most so many seconds old has led to that request.
  void asked(std::uint64_t serial, double age);

  // A picture is on the screen that answers all requests up to that one; a new one, or the last
  // with more samples.
  void shown(std::uint64_t serial);

  double lastLatency() const { return latencies_.empty() ? 0 : latencies_.back(); }
  // While requests follow each other.
  double framesPerSecond() const;

  // All of them, in seconds.
  const std::vector<double>& latencies() const { return latencies_; }
  const std::vector<double>& intervals() const { return intervals_; }

 private:
  struct Waiting {
    std::uint64_t serial;
    double since;  // on the clock
  };

  Stopwatch clock_;
  std::deque<Waiting> waiting_;
  std::vector<double> latencies_;
  std::vector<double> intervals_;  // between pictures that answer something
  double last_answer_ = -1;
};

// Of values that need not be sorted; 0 of none. `share` in [0, 1].
double quantile(std::vector<double> values, double share);

}  // namespace glimt
