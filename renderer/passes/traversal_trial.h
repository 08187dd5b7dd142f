// Which of several traversals is the fastest on this device and for this scene: found out while the
// picture is made, with samples that are part of it, so that nothing is drawn for the trial alone.
#pragma once

#include <string>
#include <vector>

#include "renderer/core/traversal_time.h"

namespace glimt {

class TraversalTrial {
 public:
  // The first of the candidates is used until the trial begins, and kept unless another is faster.
  // With only one there is nothing to try.
  explicit TraversalTrial(std::vector<std::string> candidates);

  // What the next sample is to be drawn with.
  const std::string& traversal() const { return candidates_[current_]; }

  // A sample has been drawn with it, and took so long. All have to be of one picture: the trial
  // begins once the first candidate has drawn for two seconds, since another one's programs take a
  // few tenths of a second to compile.
  void add(double seconds);

  // What was measured for each candidate, once all were tried. Empty before.
  const std::vector<TraversalTime>& times() const { return times_; }

  // The picture is another: what was measured so far is forgotten, unless the trial has ended.
  void restart();

 private:
  void decide();

  std::vector<std::string> candidates_;
  std::vector<std::vector<double>> seconds_;  // of each candidate's samples
  std::vector<TraversalTime> times_;
  std::size_t current_ = 0;
  double spent_ = 0;
};

}  // namespace glimt
