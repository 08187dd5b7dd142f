#pragma once

#include <array>
#include <optional>

namespace glimt {

// How long the rest of a batch takes, going by the seconds that a pixel took so far.
class BatchEstimate {
 public:
  // What is still to be made, and what of it is made or needs not be.
  void plan(const std::array<int, 2>& size) { left_ += pixelsOf(size); }
  void skip(const std::array<int, 2>& size) { left_ -= pixelsOf(size); }
  void done(const std::array<int, 2>& size, double seconds) {
    skip(size);
    pixels_ += pixelsOf(size);
    seconds_ += seconds;
  }

  // Of all that is left, the picture under way among it, which has taken `spent` seconds and, where
  // that is known, takes `more`. Nothing before anything is known.
  std::optional<double> secondsLeft(const std::array<int, 2>& size, double spent,
                                    const std::optional<double>& more) const {
    const double others = left_ - pixelsOf(size);
    if (!more && pixels_ == 0) return {};
    const double seconds = seconds_ + (more ? spent + *more : 0);
    const double of_pixel = seconds / (pixels_ + (more ? pixelsOf(size) : 0));
    return others * of_pixel + more.value_or(of_pixel * pixelsOf(size) - spent);
  }

 private:
  static double pixelsOf(const std::array<int, 2>& size) {
    return static_cast<double>(size[0]) * size[1];
  }

  double left_ = 0;
  double pixels_ = 0;
  double seconds_ = 0;
};

}  // namespace glimt
