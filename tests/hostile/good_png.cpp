#include "tests/hostile/good_png.h"

#include <stb_image_write.h>

#include <cstdint>
#include <cstdlib>
#include <memory>
#include <string_view>
#include <utility>

// stb has it, but does not declare it everywhere.
extern "C" unsigned char* stbi_zlib_compress(unsigned char* data, int data_len, int* out_len,
                                             int quality);

namespace glimt {
namespace {

void appendNumber(std::string& bytes, std::uint32_t number) {
  for (int shift = 24; shift >= 0; shift -= 8) bytes += static_cast<char>(number >> shift & 0xff);
}

std::uint32_t checksumOf(std::string_view bytes) {
  std::uint32_t crc = 0xffffffffu;
  for (const char byte : bytes) {
    crc ^= static_cast<unsigned char>(byte);
    for (int bit = 0; bit < 8; ++bit) crc = (crc >> 1) ^ ((crc & 1) != 0 ? 0xedb88320u : 0);
  }
  return ~crc;
}

void appendChunk(std::string& bytes, const std::string& name, const std::string& content) {
  appendNumber(bytes, static_cast<std::uint32_t>(content.size()));
  bytes += name + content;
  appendNumber(bytes, checksumOf(name + content));
}

int channelsOf(int color_type) {
  switch (color_type) {
    case 2:
      return 3;
    case 4:
      return 2;
    case 6:
      return 4;
    default:
      return 1;
  }
}

void appendRows(std::string& rows, int width, int height, int bits_per_pixel) {
  if (width <= 0) return;
  for (int y = 0; y < height; ++y) {
    rows += static_cast<char>(y % 5);
    for (int i = 0; i < (width * bits_per_pixel + 7) / 8; ++i) rows += static_cast<char>(i * 7 + y);
  }
}

std::string rowsOf(int width, int height, const PngKind& kind) {
  const int bits = kind.bits * channelsOf(kind.color_type);
  std::string rows;
  if (!kind.interlaced) {
    appendRows(rows, width, height, bits);
    return rows;
  }
  // Adam7: first column and row of each pass, and how far the next ones are.
  constexpr int kPasses[7][4] = {{0, 0, 8, 8}, {4, 0, 8, 8}, {0, 4, 4, 8}, {2, 0, 4, 4},
                                 {0, 2, 2, 4}, {1, 0, 2, 2}, {0, 1, 1, 2}};
  for (const auto& [left, top, across, down] : kPasses) {
    appendRows(rows, (width - left + across - 1) / across, (height - top + down - 1) / down, bits);
  }
  return rows;
}

std::string compressed(std::string bytes) {
  int size = 0;
  const std::unique_ptr<unsigned char, void (*)(void*)> out(
      stbi_zlib_compress(reinterpret_cast<unsigned char*>(bytes.data()),
                         static_cast<int>(bytes.size()), &size, 8),
      std::free);
  return std::string(reinterpret_cast<const char*>(out.get()), static_cast<std::size_t>(size));
}

// Deflate's bits, the lowest of a byte first.
class Bits {
 public:
  void add(unsigned bits, int count) {
    for (int i = 0; i < count; ++i) {
      byte_ |= (bits >> i & 1u) << filled_;
      if (++filled_ < 8) continue;
      bytes_ += static_cast<char>(byte_);
      byte_ = 0;
      filled_ = 0;
    }
  }
  std::string take() {
    add(0, 7);
    return std::move(bytes_);
  }

 private:
  std::string bytes_;
  unsigned byte_ = 0;
  int filled_ = 0;
};

}  // namespace

std::string goodPng(int width, int height, const PngKind& kind) {
  return pngOf(width, height, kind, compressed(rowsOf(width, height, kind)));
}

std::string explodingPng(std::size_t bytes) {
  Bits bits;
  bits.add(0b011, 3);       // the last block, of fixed codes
  bits.add(0b00001100, 8);  // a zero
  for (std::size_t size = 1; size < bytes; size += 258) {
    bits.add(0b00000'10100011, 13);  // 258 times the byte before
  }
  bits.add(0, 7);  // the end
  return pngOf(1, 1, {8, 0, false}, "\x78\x01" + bits.take());
}

std::string pngOf(int width, int height, const PngKind& kind, const std::string& packed) {
  std::string header;
  appendNumber(header, static_cast<std::uint32_t>(width));
  appendNumber(header, static_cast<std::uint32_t>(height));
  for (const int byte : {kind.bits, kind.color_type, 0, 0, kind.interlaced ? 1 : 0}) {
    header += static_cast<char>(byte);
  }
  std::string bytes = "\x89PNG\r\n\x1a\n";
  appendChunk(bytes, "IHDR", header);
  if (kind.color_type == 3) {
    std::string palette;
    for (int i = 0; i < 3 << kind.bits; ++i) palette += static_cast<char>(i * 5);
    appendChunk(bytes, "PLTE", palette);
  }
  appendChunk(bytes, "IDAT", packed);
  appendChunk(bytes, "IEND", "");
  return bytes;
}

}  // namespace glimt
