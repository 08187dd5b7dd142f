// What is left of a render when its context is not.
#pragma once

#include "app/stopwatch.h"
#include "renderer/renderer.h"

namespace glimt {

class SafePicture {
 public:
  // At most about so many seconds of work are not in the picture, where keeping it so often takes
  // less than a hundredth of the time. The renderer outlives this.
  SafePicture(Renderer& renderer, double seconds_at_risk)
      : renderer_(renderer), seconds_at_risk_(seconds_at_risk) {}

  // Keeps the complete samples if it is time to; the first one at once. Errors: failed, when GL
  // gives the picture no more.
  void keepWhenDue();
  void keep();

  // After a failure: what GL still gives, or else what was kept.
  void rescue() noexcept;

  const Picture& get() const { return picture_; }

 private:
  Renderer& renderer_;
  double seconds_at_risk_;
  double wait_ = 0;  // seconds after the last time
  Stopwatch since_last_;
  Picture picture_;
};

}  // namespace glimt
