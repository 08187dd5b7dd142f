#include "renderer/core/png_data.h"

#include <stb_image.h>

#include <array>
#include <cstdint>
#include <string>

#include "renderer/core/error.h"
#include "renderer/core/png_chunks.h"

namespace glimt {
namespace {

// Writers may add something behind the last row, which nobody looks at.
constexpr std::int64_t kSpare = 1 << 16;
// stb_image holds the packed data, the unpacked ones and the pixels at the same time.
constexpr std::int64_t kMostUnpacked = (1 << 28) + (1 << 20);

[[noreturn]] void bad(const std::string& what) {
  throw Error(ErrorKind::input, what + "; write the picture again");
}

std::uint32_t numberAt(std::string_view bytes, std::size_t position) {
  std::uint32_t number = 0;
  for (std::size_t i = 0; i < 4; ++i) {
    number = number << 8 | static_cast<unsigned char>(bytes[position + i]);
  }
  return number;
}

struct PngData {
  std::string header;  // the content of IHDR
  std::string packed;  // of all IDAT
};

PngData dataOf(std::string_view bytes) {
  PngData data;
  for (const auto& [name, content] : pngChunksOf(bytes)) {
    // Apple's variant, whose data are packed in another way.
    if (name == "CgBI") bad("a PNG picture of the kind that only Apple's programs read");
    if (name == "IHDR" && data.header.empty()) data.header = content;
    if (name == "IDAT") data.packed += content;
  }
  if (data.header.size() != 13) bad("damaged PNG picture (no header)");
  return data;
}

std::int64_t rowsSize(std::int64_t width, std::int64_t height, std::int64_t bits_per_pixel) {
  return width > 0 && height > 0 ? height * (1 + (width * bits_per_pixel + 7) / 8) : 0;
}

// Of all rows, each with its filter; in an interlaced picture those of the seven smaller ones.
std::int64_t unpackedSize(const std::string& header) {
  const std::int64_t width = numberAt(header, 0);
  const std::int64_t height = numberAt(header, 4);
  constexpr std::array<int, 8> kChannels = {1, 1, 3, 1, 2, 1, 4, 1};
  const std::int64_t bits = header[8] * kChannels[static_cast<unsigned char>(header[9]) % 8];
  if (header[12] == 0) return rowsSize(width, height, bits);
  // Adam7: first column and row of each, and how far the next ones are.
  constexpr int kPasses[7][4] = {{0, 0, 8, 8}, {4, 0, 8, 8}, {0, 4, 4, 8}, {2, 0, 4, 4},
                                 {0, 2, 2, 4}, {1, 0, 2, 2}, {0, 1, 1, 2}};
  std::int64_t size = 0;
  for (const auto& [left, top, across, down] : kPasses) {
    size += rowsSize((width - left + across - 1) / across, (height - top + down - 1) / down, bits);
  }
  return size;
}

}  // namespace

void demandBoundedPngData(std::string_view bytes) {
  const PngData data = dataOf(bytes);
  const std::int64_t size = unpackedSize(data.header);
  if (size > kMostUnpacked) {
    throw Error(ErrorKind::input,
                "the PNG picture needs more than 2 GiB of memory to be read; make "
                "it smaller, or store eight bits a channel");
  }
  // What cannot be packed grows by a few bytes in a thousand.
  if (static_cast<std::int64_t>(data.packed.size()) > size + size / 8 + kSpare) {
    bad("the PNG picture's data are more than its size calls for");
  }
  std::string unpacked(static_cast<std::size_t>(size + kSpare), '\0');
  if (stbi_zlib_decode_buffer(unpacked.data(), static_cast<int>(unpacked.size()),
                              data.packed.data(), static_cast<int>(data.packed.size())) < 0) {
    bad("the PNG picture's data are damaged, or more than its size calls for");
  }
}

}  // namespace glimt
