// A kind of work, drawn over a square picture and timed.
#pragma once

#include <optional>
#include <vector>

#include "renderer/bench/device_work.h"
#include "renderer/gl/device.h"
#include "renderer/gl/program.h"

namespace glimt {

class WorkProgram {
 public:
  // `texels` has the size that the work asks for, and stays. The loop gets as many turns as make a
  // draw of the tile long enough to be timed. Errors: failed.
  WorkProgram(const gl::Device& device, const DeviceWork& work, const gl::Texture& texels,
              const gl::Target& target, const gl::Tile& tile);

  // The seconds of each draw, after one that is not timed.
  std::vector<double> run(int repeats);

  // Of the work's own unit, in one pixel of a draw.
  double amountPerPixel() const { return work_.amount_per_turn * turns_; }

 private:
  void compile(int turns);
  double draw();

  const gl::Device* device_;
  DeviceWork work_;
  const gl::Texture* texels_;
  const gl::Target* target_;
  gl::Tile tile_;
  int turns_ = 0;
  std::optional<gl::Program> program_;
};

}  // namespace glimt
