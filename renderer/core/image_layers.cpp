#include "renderer/core/image_layers.h"

#include <fmt/format.h>

#include "renderer/core/error.h"
#include "renderer/core/file.h"
#include "renderer/core/image_codecs.h"
#include "renderer/core/image_file.h"
#include "renderer/core/wording.h"

namespace glimt {
namespace {

// Of pictures as large as are read, with some twenty channels.
constexpr std::uintmax_t kLargestFile = std::uintmax_t{1900} << 20;

}  // namespace

ImageLayers layersOf(const Image& image) {
  ImageLayers layers{image.width, image.height, {}, {}};
  for (int c = 0; c < 3; ++c) {
    std::vector<float>& channel = layers.channels[std::string(1, "RGB"[c])];
    channel.reserve(image.pixels.size());
    for (const Vec3& pixel : image.pixels) channel.push_back(pixel[c]);
  }
  if (!image.alpha.empty()) layers.channels["A"] = image.alpha;
  if (image.denoised) layers.notes[kDenoisedKey] = kDenoisedText;
  return layers;
}

ImageLayers readLayers(const std::filesystem::path& path) {
  if (imageFormatOf(path) != ImageFormat::exr)
    throw Error(ErrorKind::input,
                fmt::format("{}: only an .exr has layers", printable(path.string())));
  const std::string bytes = readFile(path, kLargestFile);
  try {
    return decodeLayers(bytes);
  } catch (const Error& error) {
    throw Error(error.kind(), fmt::format("{}: {}", printable(path.string()), error.what()));
  } catch (const std::bad_alloc&) {
    throw Error(ErrorKind::input, fmt::format("{}: the picture needs more memory than there is; "
                                              "make it smaller",
                                              printable(path.string())));
  }
}

void writeLayers(const std::filesystem::path& path, const ImageLayers& layers) {
  writeFile(path, encodeLayers(layers));
}

}  // namespace glimt
