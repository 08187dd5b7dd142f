// PNG pictures of the kinds that glimt itself does not write.
#pragma once

#include <string>

namespace glimt {

struct PngKind {
  int bits;        // a channel: 1, 2, 4, 8 or 16
  int color_type;  // 0 grey, 2 RGB, 3 palette, 4 grey with alpha, 6 RGB with alpha
  bool interlaced;
};

// A pattern of `width` times `height` pixels, below 256 each, with a filter of every kind.
std::string goodPng(int width, int height, const PngKind& kind);

// A PNG of that header, whatever its packed data are.
std::string pngOf(int width, int height, const PngKind& kind, const std::string& packed);

// Of one pixel, with data that unpack to `bytes` bytes, 158 times what they take packed.
std::string explodingPng(std::size_t bytes);

}  // namespace glimt
