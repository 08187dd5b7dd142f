// Pictures as the bytes of a file, one pair of functions a format. Decoders throw Error input, with
// a message that leaves the path to the caller: "what is wrong; what to do".
#pragma once

#include <string>
#include <string_view>

#include "renderer/core/image.h"

namespace glimt {

// No picture of more pixels is read, since a file of a few bytes may claim any size: as much as
// 16-bit PNGs and files of many channels can have within 2 GiB of memory.
inline constexpr long long kMostPixels = 1LL << 26;

// How files of a denoised picture say so: a text chunk, an attribute or a line of the header.
inline constexpr const char* kDenoisedKey = "denoised";
inline constexpr const char* kDenoisedText = "by glimt: less noise than its samples have";

// Throws Error input unless the size is sensible and the file is long enough to hold the pixels,
// given how many pixels one byte can hold at most in its format.
void demandPlausibleSize(long long width, long long height, std::size_t bytes,
                         double most_pixels_per_byte);

// Portable float map: RGB or grey, rows from the bottom. Written little-endian. Has no room for
// what a picture says of itself.
Image decodePfm(std::string_view bytes);
std::string encodePfm(const Image& image);

// OpenEXR: one part in scan lines, channels R G B or one grey one. Written as 32-bit floats, with
// an alpha where the picture has one. More than that: image_layers.h.
Image decodeExr(std::string_view bytes);
std::string encodeExr(const Image& image);

// Radiance RGBE. Eight bits a channel share one exponent; negative values become zero.
Image decodeHdr(std::string_view bytes);
std::string encodeHdr(const Image& image);

// PNG, sRGB. Decoding makes it linear and forgets transparency; written is it where the picture has
// an alpha.
Image decodePng(std::string_view bytes);
std::string encodePng(const DisplayImage& image);

}  // namespace glimt
