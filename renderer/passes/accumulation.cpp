#include "renderer/passes/accumulation.h"

#include <algorithm>

namespace glimt {
namespace {

gl::Program makeProgram(const gl::Device& device, Pass pass, bool clamp = false,
                        Accumulated accumulated = Accumulated::radiance) {
  ShaderRequest request;
  request.pass = pass;
  request.accumulated = accumulated;
  request.clamp = clamp;
  request.additive_blending = device.floatBlending();
  return {device.gl(), nameOf(pass), composeVertexShader(), composeFragmentShader(request)};
}

// As meanWithBlock in shaders/sample_mean.glsl.
Vec4 meanWithBlock(const Vec4& mean, const Vec4& block) {
  const float count = mean.w + block.w;
  const Vec3 before(mean);
  return {before + (Vec3(block) - block.w * before) / std::max(count, 1.0f), count};
}

}  // namespace

Accumulation::Accumulation(const gl::Device& device, const std::optional<float>& clamp,
                           Accumulated accumulated)
    : device_(&device),
      accumulate_(makeProgram(device, Pass::accumulate, clamp.has_value(), accumulated)),
      close_block_(makeProgram(device, Pass::close_block)),
      clamp_(clamp.value_or(0)) {}

void Accumulation::resize(int width, int height) {
  mean_ = TargetPair(*device_, width, height);
  block_ = TargetPair(*device_, width, height, !device_->floatBlending());
}

void Accumulation::clear() {
  mean_.clear();
  block_.clear();
}

void Accumulation::use(gl::Program& program) const {
  program.use();
  program.set("uZero", Vec4(0));
  program.set("uPictureStep", 1.0f / Vec2(mean_.front().width(), mean_.front().height()));
}

void Accumulation::add(const gl::Texture& radiance, const gl::Tile& tile) {
  use(accumulate_);
  accumulate_.set("uRadiance", radiance);
  accumulate_.set("uClamp", clamp_);
  gl::DrawState state;
  if (device_->floatBlending()) {
    state.adding = true;
    block_.front().bind();
  } else {
    accumulate_.set("uBlock", block_.front().texture());
    block_.back().bind();
  }
  device_->draw(tile, state);
}

void Accumulation::endSample() {
  if (!device_->floatBlending()) block_.swap();
}

void Accumulation::closeBlock(const gl::Tile& tile) {
  use(close_block_);
  bind(close_block_);
  mean_.back().bind();
  device_->draw(tile);
}

void Accumulation::endBlock() {
  mean_.swap();
  block_.clear();
}

void Accumulation::bind(gl::Program& program, const char* mean, const char* block) const {
  program.set(mean, mean_.front().texture());
  program.set(block, block_.front().texture());
}

std::vector<Vec4> Accumulation::readMean() const {
  std::vector<Vec4> mean = mean_.front().readFloats();
  const std::vector<Vec4> block = block_.front().readFloats();
  for (std::size_t i = 0; i < mean.size(); ++i) mean[i] = meanWithBlock(mean[i], block[i]);
  return mean;
}

}  // namespace glimt
