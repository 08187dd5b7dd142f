#include "app/safe_picture.h"

#include <algorithm>
#include <exception>

namespace glimt {

void SafePicture::keepWhenDue() {
  if (since_last_.seconds() >= wait_) keep();
}

void SafePicture::keep() {
  constexpr double kMostOfTheTime = 0.01;
  if (renderer_.samples() == picture_.samples) return;
  const Stopwatch clock;
  picture_ = renderer_.picture();
  wait_ = std::max(seconds_at_risk_, clock.seconds() / kMostOfTheTime);
  since_last_ = Stopwatch();
}

void SafePicture::rescue() noexcept {
  try {
    keep();
  } catch (const std::exception&) {  // why has been told by what failed before
  }
}

}  // namespace glimt
