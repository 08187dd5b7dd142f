#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <charconv>
#include <cmath>
#include <cstdint>

#include "renderer/core/error.h"
#include "renderer/core/image_codecs.h"

namespace glimt {
namespace {

struct PfmHeader {
  int channels = 3;
  int width = 0;
  int height = 0;
  bool big_endian = false;
};

[[noreturn]] void bad(const std::string& what) {
  throw Error(ErrorKind::input, what + "; write the picture again");
}

bool isSpace(char c) {
  return c == ' ' || c == '\t' || c == '\n' || c == '\r';
}

// Takes one word off the front, and exactly one white space behind it: after the header's last
// word the floats begin, whatever they look like.
std::string_view takeWord(std::string_view& bytes) {
  while (!bytes.empty() && isSpace(bytes.front())) bytes.remove_prefix(1);
  std::size_t length = 0;
  while (length < bytes.size() && !isSpace(bytes[length])) ++length;
  const std::string_view word = bytes.substr(0, length);
  bytes.remove_prefix(std::min(length + 1, bytes.size()));
  return word;
}

template <typename Number>
Number takeNumber(std::string_view& bytes, const char* what) {
  const std::string_view word = takeWord(bytes);
  Number value{};
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
  if (error != std::errc() || end != word.data() + word.size()) {
    bad(fmt::format("the PFM header has no {}", what));
  }
  return value;
}

PfmHeader takeHeader(std::string_view& bytes) {
  PfmHeader header;
  const std::string_view magic = takeWord(bytes);
  if (magic != "PF" && magic != "Pf") bad("not a PFM file (it begins with neither PF nor Pf)");
  header.channels = magic == "PF" ? 3 : 1;
  header.width = takeNumber<int>(bytes, "width");
  header.height = takeNumber<int>(bytes, "height");
  const float scale = takeNumber<float>(bytes, "scale");
  if (!std::isfinite(scale) || scale == 0) bad("the PFM header's scale is zero or not finite");
  header.big_endian = scale > 0;
  return header;
}

float floatAt(const char* bytes, bool big_endian) {
  std::uint32_t bits = 0;
  for (int i = 0; i < 4; ++i) {
    const auto byte = static_cast<unsigned char>(bytes[big_endian ? 3 - i : i]);
    bits |= static_cast<std::uint32_t>(byte) << (8 * i);
  }
  return std::bit_cast<float>(bits);
}

void append(std::string& bytes, float value) {
  const auto bits = std::bit_cast<std::uint32_t>(value);
  for (int i = 0; i < 4; ++i) bytes += static_cast<char>(bits >> (8 * i) & 0xff);
}

}  // namespace

Image decodePfm(std::string_view bytes) {
  const PfmHeader header = takeHeader(bytes);
  demandPlausibleSize(header.width, header.height, bytes.size(), 0.25);
  const auto width = static_cast<std::size_t>(header.width);
  const auto height = static_cast<std::size_t>(header.height);
  const auto channels = static_cast<std::size_t>(header.channels);
  if (bytes.size() < 4 * channels * width * height) bad("the PFM file ends too early");

  Image image{header.width, header.height, std::vector<Vec3>(width * height)};
  for (std::size_t y = 0; y < height; ++y) {
    const char* row = bytes.data() + 4 * channels * width * (height - 1 - y);
    for (std::size_t x = 0; x < width; ++x) {
      for (std::size_t c = 0; c < 3; ++c) {
        const char* value = row + 4 * (channels * x + (channels == 3 ? c : 0));
        image.pixels[y * width + x][static_cast<int>(c)] = floatAt(value, header.big_endian);
      }
    }
  }
  return image;
}

std::string encodePfm(const Image& image) {
  std::string bytes = fmt::format("PF\n{} {}\n-1.0\n", image.width, image.height);
  bytes.reserve(bytes.size() + 12 * image.pixels.size());
  const auto width = static_cast<std::size_t>(image.width);
  for (std::size_t y = static_cast<std::size_t>(image.height); y-- > 0;) {
    for (std::size_t x = 0; x < width; ++x) {
      const Vec3& pixel = image.pixels[y * width + x];
      for (int c = 0; c < 3; ++c) append(bytes, pixel[c]);
    }
  }
  return bytes;
}

}  // namespace glimt
