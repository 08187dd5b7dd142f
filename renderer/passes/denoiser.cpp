#include "renderer/passes/denoiser.h"

#include <algorithm>
#include <cmath>

#include "renderer/gl/errors.h"
#include "renderer/shader/composer.h"

namespace glimt {
namespace {

// Edges are as smooth with the guides of so many paths as eyes can tell.
constexpr int kMostRays = 16;

// Each doubles the distance between taps: the last one's reach over 2 * 2^4 pixels to each side.
constexpr int kLevels = 5;

// Fewer samples do not tell how much they differ.
constexpr int kLeastForSpread = 4;

// Of the time, about: the rest is the filter's.
constexpr float kGuidesShare = 0.7f;

gl::Program makeProgram(const gl::Device& device, Pass pass) {
  return {device.gl(), nameOf(pass), composeVertexShader(), composeFragmentShader(pass)};
}

}  // namespace

void Denoiser::prepare(const Film& film) {
  if (!prepare_) {
    prepare_.emplace(makeProgram(*device_, Pass::prepare));
    atrous_.emplace(makeProgram(*device_, Pass::atrous));
    finish_.emplace(makeProgram(*device_, Pass::finish));
  }
  if (light_.front().width() != film.width() || light_.front().height() != film.height())
    light_ = TargetPair(*device_, film.width(), film.height());
}

// Reads the light in front and leaves it there.
void Denoiser::draw(gl::Program& program, Pass pass) {
  gl::clearErrors(device_->gl());
  const int width = light_.front().width();
  const int height = light_.front().height();
  program.set("uZero", Vec4(0));
  program.set("uPictureStep", 1.0f / Vec2(width, height));
  guides_.bind(program);
  program.set("uLight", light_.front().texture());
  light_.back().bind();
  device_->draw({0, 0, width, height});
  gl::checkErrors(device_->gl(), "drawing the pass " + nameOf(pass));
  light_.swap();
}

// The picture's light with its variance.
void Denoiser::drawLight(const PathTracer& tracer) {
  const Accumulation* const squares = tracer.kept(Accumulated::square);
  const bool known = squares && tracer.samples() >= kLeastForSpread;
  prepare_->use();
  prepare_->set("uSpreadKnown", known ? 1.0f : 0.0f);
  tracer.accumulation().bind(*prepare_);
  (known ? *squares : tracer.accumulation()).bind(*prepare_, "uSquares", "uSquaresBlock");
  draw(*prepare_, Pass::prepare);
  if (known) return;
  if (!neighbours_) neighbours_.emplace(makeProgram(*device_, Pass::neighbours));
  neighbours_->use();
  draw(*neighbours_, Pass::neighbours);
}

const gl::Target& Denoiser::denoise(PathTracer& tracer, const WorkProgress& progress) {
  prepare(tracer.film());
  guides_.extend(tracer, std::min(tracer.samples(), kMostRays), partOf(progress, 0, kGuidesShare));
  drawLight(tracer);
  for (int level = 0; level < kLevels; ++level) {
    if (progress) progress(std::lerp(kGuidesShare, 1.0f, static_cast<float>(level) / kLevels));
    atrous_->use();
    atrous_->set("uSpacing", std::exp2(static_cast<float>(level)));
    draw(*atrous_, Pass::atrous);
    device_->gl().Finish();
  }
  finish_->use();
  tracer.accumulation().bind(*finish_);
  draw(*finish_, Pass::finish);
  if (progress) progress(1);
  return light_.front();
}

}  // namespace glimt
