// Which parts of a picture have had enough samples.
#pragma once

#include <vector>

#include "renderer/gl/device.h"

namespace glimt {

// A picture in squares of CHANGE_SQUARE x CHANGE_SQUARE pixels, rows from the bottom. With the
// noise of all of them known, the least work for a noise of the whole is the one where a bit more
// of it saves as much anywhere: of a square whose noise's square is c / n^p and whose sample takes
// the work w, n is in proportion to (c / w)^(1 / (1 + p)). All squares that are not at rest have
// the same number of samples, so one comes to rest when it has as many as are its due, and stays
// so.
class Rest {
 public:
  Rest() = default;
  Rest(int width, int height);

  // `noise` is the square of each square's noise, summed over its pixels, at `samples`; of those at
  // rest it is not looked at. It falls with that power of the samples. `goal` is what the sum over
  // all squares is to become, `lengths` how many triangles each pixel's path met in some sample,
  // which its work follows from. True where more squares have come to rest; never all.
  bool decide(const std::vector<double>& noise, const std::vector<float>& lengths, int samples,
              double power, double goal);

  // Samples of a square that is at rest; 0 for the others.
  int samplesOf(std::size_t square) const { return samples_[square]; }
  int samplesAt(int x, int y) const;  // by the pixel, y from the bottom

  // What the squares at rest add to the sum over all of them, for good.
  double noise() const { return noise_; }

  // The mean over the pixels, when the squares that are not at rest have `samples`.
  double meanSamples(int samples) const;

  // The squares at rest, in as few rectangles as rows of them need.
  std::vector<gl::Tile> tiles() const;

 private:
  gl::Tile tileOf(int column, int row, int columns) const;
  std::vector<double> smoothed(const std::vector<double>& noise) const;
  std::vector<double> workOf(const std::vector<float>& lengths) const;

  int width_ = 0;
  int height_ = 0;
  int columns_ = 0;
  int rows_ = 0;
  std::vector<int> samples_;
  double noise_ = 0;
};

}  // namespace glimt
