// Pictures for surfaces: PNG and JPEG, as they are stored.
#pragma once

#include <cstdint>
#include <string_view>
#include <vector>

namespace glimt {

struct RgbaImageSize {
  int width = 0;
  int height = 0;
};

// Four bytes a pixel: red, green, blue, alpha; rows from the top. Values as in the file, whatever
// they mean there; 16 bits a channel are reduced to 8, grey is red, green and blue.
struct RgbaImage {
  int width = 0;
  int height = 0;
  std::vector<std::uint8_t> bytes;
};

// Of the file's content. Errors: input, with a message that leaves the path to the caller, for what
// is neither PNG nor JPEG, and for sizes that cannot be.
RgbaImageSize rgbaSizeOf(std::string_view bytes);

// Errors: input, also for what is damaged.
RgbaImage decodeRgba(std::string_view bytes);

}  // namespace glimt
