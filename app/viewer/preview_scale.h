#pragma once

#include <optional>

namespace glimt {

// How much smaller the picture is drawn while the camera moves, so that it keeps up with the hand.
class PreviewScale {
 public:
  // A sample of a picture of that many pixels took that long.
  void learn(double pixels, double seconds);

  // What width and height of a picture are divided by. Changes only when samples have become too
  // slow, or could be much larger: every change is seen.
  int divisorFor(double pixels);

 private:
  bool warm_ = false;
  std::optional<double> seconds_per_pixel_;
  int divisor_ = 4;
};

}  // namespace glimt
