#include "renderer/scene/texture_image.h"

#include <fmt/format.h>
#include <stb_image.h>

#include <algorithm>
#include <climits>
#include <cmath>
#include <memory>

#include "renderer/core/error.h"
#include "renderer/core/file.h"
#include "renderer/core/image_codecs.h"
#include "renderer/core/png_data.h"
#include "renderer/core/wording.h"

namespace glimt {
namespace {

constexpr std::uintmax_t kLargestFile = 512 << 20;
// A run of a thousand bytes in one, at eight pixels a byte, is what PNG can hold. Others hold less.
constexpr double kMostPixelsPerByte = 8 * 1032;

const std::uint8_t* texel(const TextureImage& image, int x, int y) {
  const auto column = static_cast<std::size_t>(std::min(x, image.width - 1));
  const auto row = static_cast<std::size_t>(std::min(y, image.height - 1));
  return image.rgba.data() + 4 * (row * static_cast<std::size_t>(image.width) + column);
}

TextureImage decode(std::string_view bytes) {
  const auto* data = reinterpret_cast<const stbi_uc*>(bytes.data());
  TextureImage image;
  int channels = 0;
  if (bytes.size() > INT_MAX || !stbi_info_from_memory(data, static_cast<int>(bytes.size()),
                                                       &image.width, &image.height, &channels))
    throw Error(ErrorKind::input, "no picture that can be read; use PNG or JPEG");
  demandPlausibleSize(image.width, image.height, bytes.size(), kMostPixelsPerByte);
  if (bytes.substr(0, 8) == "\x89PNG\r\n\x1a\n") demandBoundedPngData(bytes);
  const std::unique_ptr<stbi_uc, void (*)(void*)> values(
      stbi_load_from_memory(data, static_cast<int>(bytes.size()), &image.width, &image.height,
                            &channels, 4),
      stbi_image_free);
  if (!values)
    throw Error(ErrorKind::input, fmt::format("damaged picture ({}); write it again",
                                              printable(stbi_failure_reason())));
  const auto pixels =
      static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height);
  image.rgba.assign(values.get(), values.get() + 4 * pixels);
  return image;
}

}  // namespace

TextureImage decodeTextureImage(std::string_view bytes, const std::string& name) {
  try {
    TextureImage image = decode(bytes);
    image.name = name;
    return image;
  } catch (const Error& error) {
    throw Error(error.kind(), fmt::format("{}: {}", name, error.what()));
  }
}

TextureImage readTextureImage(const std::filesystem::path& path) {
  TextureImage image = decodeTextureImage(readFile(path, kLargestFile), printable(path.string()));
  image.name = printable(path.filename().string());
  return image;
}

TextureImage halved(const TextureImage& image) {
  TextureImage half;
  half.name = image.name;
  half.width = (image.width + 1) / 2;
  half.height = (image.height + 1) / 2;
  half.rgba.reserve(4 * static_cast<std::size_t>(half.width) *
                    static_cast<std::size_t>(half.height));
  for (int y = 0; y < half.height; ++y)
    for (int x = 0; x < half.width; ++x) {
      const std::array<const std::uint8_t*, 4> from{
          texel(image, 2 * x, 2 * y), texel(image, 2 * x + 1, 2 * y),
          texel(image, 2 * x, 2 * y + 1), texel(image, 2 * x + 1, 2 * y + 1)};
      for (std::size_t channel = 0; channel < 4; ++channel) {
        double sum = 0;
        for (const std::uint8_t* t : from)
          sum += channel < 3 ? double(t[channel]) * t[channel] : double(t[channel]);
        const double mean = channel < 3 ? std::sqrt(sum / 4) : sum / 4;
        half.rgba.push_back(static_cast<std::uint8_t>(mean + 0.5));
      }
    }
  return half;
}

}  // namespace glimt
