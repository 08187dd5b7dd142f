// What is kept of a picture's samples: the radiance, and what goes with it.
#pragma once

#include <optional>
#include <utility>
#include <vector>

#include "renderer/passes/accumulation.h"

namespace glimt {

// All of them get the same samples, tile by tile; see accumulation.h for the order of the calls.
class Accumulations {
 public:
  // Of the luminance's squares, and of the paths' lengths, where these are wanted. The latter and a
  // transparent background exclude each other: then there are no lengths. `clamp` is the
  // radiance's.
  Accumulations(const gl::Device& device, const std::optional<float>& clamp, bool transparent,
                bool squares, bool path_lengths);

  const Accumulation& picture() const { return parts_.front().second; }

  // Coverage where the background is transparent, and what was wanted. Null for what is not kept.
  const Accumulation* beside(Accumulated what) const;

  // Forgets all samples where that changes anything. Over a transparent background the picture is
  // not the sum of all that a sample has.
  void setTransparent(bool transparent);

  void setClamp(float clamp);
  void resize(int width, int height);
  void clear();
  void add(const gl::Texture& radiance, const gl::Tile& tile);
  void endSample();
  void closeBlock(const gl::Tile& tile);
  void endBlock();

 private:
  void make();

  const gl::Device* device_;
  std::optional<float> clamp_;
  bool transparent_;
  bool squares_;
  bool path_lengths_;
  int width_ = 0;
  int height_ = 0;
  std::vector<std::pair<Accumulated, Accumulation>> parts_;  // the picture is the first
};

}  // namespace glimt
