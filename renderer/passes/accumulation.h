// The mean of the samples of a picture, or of something else that a sample has.
#pragma once

#include <optional>
#include <vector>

#include "renderer/gl/device.h"
#include "renderer/gl/program.h"
#include "renderer/passes/film.h"
#include "renderer/shader/composer.h"

namespace glimt {

// Samples are summed in blocks of SAMPLES_PER_BLOCK, and the blocks become part of a running mean;
// see shaders/sample_mean.glsl. All draws can be cut into tiles.
class Accumulation {
 public:
  // `clamp` is the luminance above which samples are dimmed, none for never.
  explicit Accumulation(const gl::Device& device, const std::optional<float>& clamp = std::nullopt,
                        Accumulated accumulated = Accumulated::radiance);

  // Takes another clamp for the samples to come, where there was one from the beginning.
  void setClamp(float clamp) { clamp_ = clamp; }

  // Forgets all samples. Errors: as TargetPair.
  void resize(int width, int height);
  void clear();

  // Adds a tile of a sample's radiance. When the sample is complete, endSample.
  void add(const gl::Texture& radiance, const gl::Tile& tile);
  void endSample();

  // Makes a tile of the block part of the mean. When all tiles are, endBlock. To be done at every
  // SAMPLES_PER_BLOCK samples.
  void closeBlock(const gl::Tile& tile);
  void endBlock();

  // Hands both parts to a program that includes sample_mean.glsl.
  void bind(gl::Program& program) const { bind(program, "uMean", "uBlock"); }
  // The same under other names.
  void bind(gl::Program& program, const char* mean, const char* block) const;

  // The mean so far, and in the fourth channel the number of its samples. Rows from the bottom.
  std::vector<Vec4> readMean() const;

 private:
  void use(gl::Program& program) const;

  const gl::Device* device_;
  gl::Program accumulate_;
  gl::Program close_block_;
  float clamp_;
  TargetPair mean_;
  TargetPair block_;  // two only where the device cannot blend floats
};

}  // namespace glimt
