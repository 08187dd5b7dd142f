// How a picture's changes fall from one doubling of its samples to the next.
#pragma once

namespace glimt {

// The logarithm of a change, over the doublings, is a line, and each measured change is off it by
// chance, once. So the line is what to go on from: of two changes alone, the chance of both would
// be in how they fall. This is a Kalman filter of its height and slope, in logarithms to base 2.
class ChangeTrend {
 public:
  // Before the first change is seen. `power` is the power of the samples by which changes fall, as
  // it is known beforehand.
  ChangeTrend(double power, double deviation);

  // Of the change at the present doubling: what is expected, over what is measured.
  double level() const { return level_; }
  double power() const { return power_; }

  // The variance of level + by_power * power.
  double variance(double by_power) const;

  // Something has been seen whose expectation moves by 1 with the level and by `by_power` with the
  // power, is `off` below what was seen, and has that variance.
  void see(double off, double by_power, double variance);

  // At the next doubling, whose change is measured to be 2^-fall of the present one.
  void advance(double fall);

 private:
  double level_ = 0;
  double power_;
  double level_variance_;
  double covariance_ = 0;
  double power_variance_;
};

}  // namespace glimt
