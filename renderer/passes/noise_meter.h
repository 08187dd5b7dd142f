// Measures the noise of a picture while it is made.
#pragma once

#include <optional>
#include <vector>

#include "renderer/gl/device.h"
#include "renderer/gl/program.h"
#include "renderer/passes/accumulation.h"
#include "renderer/passes/film.h"
#include "renderer/passes/noise.h"
#include "renderer/passes/rest.h"
#include "renderer/shader/composer.h"

namespace glimt {

// Keeps the picture's luminance at the last two powers of two of samples, and reads back sums over
// squares of pixels. Compiles its programs when the first is needed. Errors of everything that
// draws: as gl::checkErrors.
class NoiseMeter {
 public:
  explicit NoiseMeter(const gl::Device& device) : device_(&device) {}

  // Another picture begins. Errors: as TargetPair.
  void restart(int width, int height, Sampler sampler);

  // Lets the parts of the picture rest that are good enough for a noise of the whole of `goal`, see
  // rest.h; none: every pixel has all samples. What rests already stays so until restart().
  void restBelow(std::optional<double> goal) { goal_ = goal; }

  // The squares at rest get no more samples from now on.
  const Rest& rest() const { return rest_; }

  // After each complete sample. Draws at powers of two, and three times between them where squares
  // may come to rest, see Rest::decide. True where more have.
  bool endSample(const Accumulation& accumulation, int samples, const std::vector<float>& lengths);

  // Nothing before Noise::kFirst samples. Pixels that a sample under way has been added to already
  // count with it.
  std::optional<NoiseEstimate> measure(const Accumulation& accumulation, int samples);

  // The same, at most so often that it takes a hundredth of the time: else what it was then.
  std::optional<NoiseEstimate> measureWhenDue(const Accumulation& accumulation, int samples);

  // Seconds spent on it, for this picture.
  double seconds() const { return seconds_; }

 private:
  void prepare();
  void keep(const Accumulation& accumulation);
  ChangeSums changeSince(const Accumulation& accumulation, bool last);
  ChangeSums readChange(const Accumulation& accumulation, bool last);
  bool decideRest(int samples, const std::vector<float>& lengths);
  void use(gl::Program& program, const Accumulation& accumulation) const;
  void drawChecked(int width, int height, Pass pass) const;

  const gl::Device* device_;
  std::optional<gl::Program> keep_;
  std::optional<gl::Program> change_;
  TargetPair kept_;
  gl::Target sums_;
  int width_ = 0;
  int height_ = 0;
  int last_ = 0;  // samples when the luminance was kept
  double floor_ = 0;
  Noise noise_;
  std::vector<Vec4> squares_;  // the last change, see shaders/change.glsl
  std::optional<double> goal_;
  Rest rest_;
  std::optional<NoiseEstimate> estimate_;
  double seconds_ = 0;
  double next_ = 0;  // when the next measurement may be
};

}  // namespace glimt
