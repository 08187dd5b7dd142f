#include "renderer/passes/accumulations.h"

namespace glimt {

Accumulations::Accumulations(const gl::Device& device, const std::optional<float>& clamp,
                             bool transparent, bool squares, bool path_lengths)
    : device_(&device),
      clamp_(clamp),
      transparent_(transparent),
      squares_(squares),
      path_lengths_(path_lengths) {
  make();
}

void Accumulations::make() {
  const auto keep = [&](Accumulated what, const std::optional<float>& clamp = std::nullopt) {
    parts_.emplace_back(what, Accumulation(*device_, clamp, what));
  };
  parts_.clear();
  keep(transparent_ ? Accumulated::seen_radiance : Accumulated::radiance, clamp_);
  if (transparent_) keep(Accumulated::coverage);
  if (squares_) keep(Accumulated::square);
  if (path_lengths_ && !transparent_) keep(Accumulated::path_length);
  if (width_ > 0) resize(width_, height_);
}

const Accumulation* Accumulations::beside(Accumulated what) const {
  for (const auto& [kept, accumulation] : parts_)
    if (kept == what) return &accumulation;
  return nullptr;
}

void Accumulations::setTransparent(bool transparent) {
  if (transparent == transparent_) return;
  transparent_ = transparent;
  make();
}

void Accumulations::setClamp(float clamp) {
  if (!clamp_) return;
  clamp_ = clamp;
  parts_.front().second.setClamp(clamp);
}

void Accumulations::resize(int width, int height) {
  width_ = width;
  height_ = height;
  for (auto& [what, accumulation] : parts_) accumulation.resize(width, height);
}

void Accumulations::clear() {
  for (auto& [what, accumulation] : parts_) accumulation.clear();
}

void Accumulations::add(const gl::Texture& radiance, const gl::Tile& tile) {
  for (auto& [what, accumulation] : parts_) accumulation.add(radiance, tile);
}

void Accumulations::endSample() {
  for (auto& [what, accumulation] : parts_) accumulation.endSample();
}

void Accumulations::closeBlock(const gl::Tile& tile) {
  for (auto& [what, accumulation] : parts_) accumulation.closeBlock(tile);
}

void Accumulations::endBlock() {
  for (auto& [what, accumulation] : parts_) accumulation.endBlock();
}

}  // namespace glimt
