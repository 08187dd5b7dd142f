#include "renderer/passes/noise_meter.h"

#include <bit>
#include <chrono>

#include "renderer/gl/errors.h"
#include "renderer/shader/composer.h"
#include "shaders/layout.h"

namespace glimt {
namespace {

// At least this many times the duration of a measurement is between two of them.
constexpr double kRest = 100;

constexpr int kFirstKept = Noise::kFirst / 2;

// Before that it is hardly known where the noise is.
constexpr int kFirstRest = 32;

double now() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

gl::Program makeProgram(const gl::Device& device, Pass pass) {
  return {device.gl(), nameOf(pass), composeVertexShader(), composeFragmentShader(pass)};
}

int squares(int pixels) {
  return (pixels + CHANGE_SQUARE - 1) / CHANGE_SQUARE;
}

}  // namespace

void NoiseMeter::restart(int width, int height, Sampler sampler) {
  if (width != width_ || height != height_) kept_ = TargetPair();
  width_ = width;
  height_ = height;
  last_ = 0;
  noise_ = Noise(sampler);
  rest_ = Rest(width, height);
  estimate_.reset();
  seconds_ = 0;
  next_ = 0;
}

// A preview that begins again and again at every move of the camera needs none of it.
void NoiseMeter::prepare() {
  if (!keep_) {
    keep_.emplace(makeProgram(*device_, Pass::keep));
    change_.emplace(makeProgram(*device_, Pass::change));
  }
  if (kept_.front().width() > 0) return;
  kept_ = TargetPair(*device_, width_, height_);
  sums_ = gl::Target(
      gl::Texture::floats(device_->gl(), device_->floatForm(), squares(width_), squares(height_)));
}

void NoiseMeter::use(gl::Program& program, const Accumulation& accumulation) const {
  program.use();
  program.set("uZero", Vec4(0));
  program.set("uPictureStep", 1.0f / Vec2(width_, height_));
  accumulation.bind(program);
  program.set("uKept", kept_.front().texture());
}

void NoiseMeter::drawChecked(int width, int height, Pass pass) const {
  gl::clearErrors(device_->gl());
  device_->draw({0, 0, width, height});
  gl::checkErrors(device_->gl(), "drawing the pass " + nameOf(pass));
}

void NoiseMeter::keep(const Accumulation& accumulation) {
  use(*keep_, accumulation);
  kept_.back().bind();
  drawChecked(width_, height_, Pass::keep);
  kept_.swap();
}

ChangeSums NoiseMeter::readChange(const Accumulation& accumulation, bool last) {
  use(*change_, accumulation);
  change_->set("uSinceLast", last ? 1.0f : 0.0f);
  change_->set("uFloor", static_cast<float>(floor_));
  sums_.bind();
  drawChecked(sums_.width(), sums_.height(), Pass::change);
  squares_ = sums_.readFloats();
  ChangeSums sums;
  for (std::size_t i = 0; i < squares_.size(); ++i) {
    sums.luminance += squares_[i].w;
    if (rest_.samplesOf(i) > 0) continue;
    sums.squares += squares_[i].x;
    sums.fourths += squares_[i].y;
    sums.squares_before += squares_[i].z;
  }
  sums.resting = rest_.noise();
  sums.pixels = static_cast<double>(width_) * height_;
  return sums;
}

// The floor is of the time before: the mean luminance hardly changes.
ChangeSums NoiseMeter::changeSince(const Accumulation& accumulation, bool last) {
  const double start = now();
  if (floor_ == 0) {
    const ChangeSums sums = readChange(accumulation, last);
    floor_ = kNoiseFloor * sums.luminance / sums.pixels;
  }
  const ChangeSums sums = readChange(accumulation, last);
  floor_ = kNoiseFloor * sums.luminance / sums.pixels;
  const double end = now();
  seconds_ += end - start;
  next_ = end + kRest * (end - start);
  return sums;
}

bool NoiseMeter::endSample(const Accumulation& accumulation, int samples,
                           const std::vector<float>& lengths) {
  if (samples < kFirstKept) return false;
  if (!std::has_single_bit(static_cast<unsigned>(samples))) {
    if (!goal_ || samples < kFirstRest || samples % (last_ / 4) != 0) return false;
    measure(accumulation, samples);
    return decideRest(samples, lengths);
  }
  prepare();
  bool more_rest = false;
  if (samples >= Noise::kFirst) {
    const ChangeSums sums = changeSince(accumulation, true);
    if (samples >= 2 * Noise::kFirst) noise_.doubled(sums, samples);
    estimate_ = noise_.estimate(sums, samples);
    more_rest = decideRest(samples, lengths);
  }
  keep(accumulation);
  last_ = samples;
  return more_rest;
}

// After a measurement. The upper end of the estimate is what has to meet the goal.
bool NoiseMeter::decideRest(int samples, const std::vector<float>& lengths) {
  if (!goal_ || samples < kFirstRest || !(estimate_->upper > 0)) return false;
  const double pixels = static_cast<double>(width_) * height_;
  double change = 0;
  for (std::size_t i = 0; i < squares_.size(); ++i)
    if (rest_.samplesOf(i) == 0) change += squares_[i].x;
  if (!(change > 0)) return false;
  const double active =
      estimate_->relative * estimate_->relative * (1 - estimate_->resting) * pixels;
  std::vector<double> noise;
  for (const Vec4& sums : squares_) noise.push_back(sums.x * active / change);
  const double goal = *goal_ * estimate_->relative / estimate_->upper;
  return rest_.decide(noise, lengths, samples, estimate_->exponent(), goal * goal * pixels);
}

std::optional<NoiseEstimate> NoiseMeter::measure(const Accumulation& accumulation, int samples) {
  if (estimate_ && samples > estimate_->samples)
    estimate_ = noise_.estimate(changeSince(accumulation, false), samples);
  return estimate_;
}

std::optional<NoiseEstimate> NoiseMeter::measureWhenDue(const Accumulation& accumulation,
                                                        int samples) {
  return now() < next_ ? estimate_ : measure(accumulation, samples);
}

}  // namespace glimt
