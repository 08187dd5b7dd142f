// Pictures in memory.
#pragma once

#include <cstdint>
#include <vector>

#include "renderer/core/vector.h"

namespace glimt {

// Linear radiance, Rec. 709 primaries; rows from the top, pixels from the left.
struct Image {
  int width = 0;
  int height = 0;
  std::vector<Vec3> pixels;
  // How much of each pixel is covered, 0 to 1, the radiance being that of what covers it
  // (associated alpha); empty: all of all.
  std::vector<float> alpha = {};
  bool denoised = false;  // its noise is not all there any more, which files of it tell
};

// Display values, sRGB-encoded, three bytes a pixel; rows from the top, pixels from the left.
struct DisplayImage {
  int width = 0;
  int height = 0;
  std::vector<std::uint8_t> bytes;
  std::vector<std::uint8_t> alpha = {};  // of each pixel, not multiplied with it; empty: opaque
  bool denoised = false;                 // as Image's
};

}  // namespace glimt
