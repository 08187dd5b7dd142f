#include "renderer/core/png_chunks.h"

#include <cstdint>

#include "renderer/core/error.h"

namespace glimt {
namespace {

constexpr std::size_t kSignature = 8;
// A chunk is its length, its name, its content, and a checksum.
constexpr std::size_t kAroundContent = 12;
// Of the first chunk, the header.
constexpr std::size_t kHeader = kAroundContent + 13;

std::uint32_t numberAt(std::string_view bytes) {
  std::uint32_t number = 0;
  for (std::size_t i = 0; i < 4; ++i) number = number << 8 | static_cast<unsigned char>(bytes[i]);
  return number;
}

std::string bytesOf(std::uint32_t number) {
  std::string bytes;
  for (int shift = 24; shift >= 0; shift -= 8) bytes += static_cast<char>(number >> shift & 0xff);
  return bytes;
}

// CRC-32 as PNG's Annex D has it, bit by bit: texts are short.
std::uint32_t checksumOf(std::string_view bytes) {
  std::uint32_t crc = 0xffffffff;
  for (const char byte : bytes) {
    crc ^= static_cast<unsigned char>(byte);
    for (int bit = 0; bit < 8; ++bit) crc = crc >> 1 ^ (crc & 1 ? 0xedb88320 : 0);
  }
  return ~crc;
}

}  // namespace

std::vector<PngChunk> pngChunksOf(std::string_view bytes) {
  std::vector<PngChunk> chunks;
  bytes.remove_prefix(kSignature);
  while (bytes.size() >= kAroundContent) {
    const std::uint32_t length = numberAt(bytes);
    const std::string_view name = bytes.substr(4, 4);
    if (length > bytes.size() - kAroundContent)
      throw Error(ErrorKind::input, "the PNG picture ends too early; write the picture again");
    if (name == "IEND") break;
    chunks.push_back({name, bytes.substr(8, length)});
    bytes.remove_prefix(kAroundContent + length);
  }
  return chunks;
}

std::string withPngText(const std::string& png, std::string_view keyword, std::string_view text) {
  const std::string content = std::string(keyword) + '\0' + std::string(text);
  const std::string checked = "tEXt" + content;
  const std::string chunk =
      bytesOf(static_cast<std::uint32_t>(content.size())) + checked + bytesOf(checksumOf(checked));
  return std::string(png).insert(kSignature + kHeader, chunk);
}

bool hasPngText(std::string_view bytes, std::string_view keyword) {
  for (const PngChunk& chunk : pngChunksOf(bytes))
    if (chunk.name == "tEXt" && chunk.content.substr(0, chunk.content.find('\0')) == keyword)
      return true;
  return false;
}

}  // namespace glimt
