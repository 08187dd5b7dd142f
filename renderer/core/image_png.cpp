#include <fmt/format.h>
#include <stb_image.h>
#include <stb_image_write.h>

#include <array>
#include <climits>
#include <cmath>
#include <memory>

#include "renderer/core/error.h"
#include "renderer/core/image_codecs.h"
#include "renderer/core/png_chunks.h"
#include "renderer/core/png_data.h"
#include "renderer/core/srgb.h"
#include "renderer/core/wording.h"

namespace glimt {
namespace {

std::array<float, 256> linearTable() {
  std::array<float, 256> table{};
  for (std::size_t i = 0; i < table.size(); ++i)
    table[i] = static_cast<float>(linearOfSrgb(static_cast<std::uint8_t>(i)));
  return table;
}

void append(void* bytes, void* data, int size) {
  static_cast<std::string*>(bytes)->append(static_cast<const char*>(data),
                                           static_cast<std::size_t>(size));
}

std::string encodePixels(const DisplayImage& image) {
  std::string bytes;
  if (!image.alpha.empty()) {
    std::vector<std::uint8_t> texels;
    texels.reserve(4 * image.alpha.size());
    for (std::size_t i = 0; i < image.alpha.size(); ++i) {
      texels.insert(texels.end(), &image.bytes[3 * i], &image.bytes[3 * i] + 3);
      texels.push_back(image.alpha[i]);
    }
    stbi_write_png_to_func(append, &bytes, image.width, image.height, 4, texels.data(),
                           4 * image.width);
    return bytes;
  }
  stbi_write_png_to_func(append, &bytes, image.width, image.height, 3, image.bytes.data(),
                         3 * image.width);
  return bytes;
}

}  // namespace

Image decodePng(std::string_view bytes) {
  const auto* data = reinterpret_cast<const stbi_uc*>(bytes.data());
  int width = 0;
  int height = 0;
  int channels = 0;
  if (bytes.size() > INT_MAX || bytes.substr(0, 8) != "\x89PNG\r\n\x1a\n" ||
      !stbi_info_from_memory(data, static_cast<int>(bytes.size()), &width, &height, &channels)) {
    throw Error(ErrorKind::input, "not a PNG picture; write the picture again");
  }
  // Deflate packs at most 1032 bytes into one, and PNG eight pixels into a byte.
  demandPlausibleSize(width, height, bytes.size(), 8 * 1032);
  demandBoundedPngData(bytes);
  const std::unique_ptr<stbi_uc, void (*)(void*)> values(
      stbi_load_from_memory(data, static_cast<int>(bytes.size()), &width, &height, &channels, 3),
      stbi_image_free);
  if (!values) {
    throw Error(ErrorKind::input, fmt::format("damaged PNG picture ({}); write it again",
                                              // which holds bytes of the file
                                              printable(stbi_failure_reason())));
  }
  const std::array<float, 256> linear = linearTable();
  Image image{width, height, {}};
  image.pixels.resize(static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
  for (std::size_t i = 0; i < image.pixels.size(); ++i) {
    const stbi_uc* value = values.get() + 3 * i;
    image.pixels[i] = Vec3(linear[value[0]], linear[value[1]], linear[value[2]]);
  }
  image.denoised = hasPngText(bytes, kDenoisedKey);
  return image;
}

std::string encodePng(const DisplayImage& image) {
  const std::string bytes = encodePixels(image);
  return image.denoised ? withPngText(bytes, kDenoisedKey, kDenoisedText) : bytes;
}

}  // namespace glimt
