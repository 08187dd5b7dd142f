#include "renderer/scene/gltf_image.h"

#include <fmt/format.h>

#include "renderer/core/error.h"
#include "renderer/core/image_rgba.h"
#include "renderer/core/wording.h"
#include "renderer/scene/gltf_uri.h"

namespace glimt {
namespace {

constexpr std::uintmax_t kLargestImageFile = 256 << 20;
// Of all pictures together: 512 MiB.
constexpr std::size_t kMostPixelsOfAll = 1 << 27;

}  // namespace

std::string GltfImages::bytesOf(std::size_t image) const {
  const GltfImageSource& source = document_.images[image];
  const std::string who = fmt::format("image {}", image);
  if (source.buffer_view >= 0) return std::string(document_.bytesOf(source.buffer_view, who));
  return readGltfUri(document_.path, source.uri, who, kLargestImageFile);
}

std::uint32_t GltfImages::load(int image) {
  if (image < 0 || static_cast<std::size_t>(image) >= document_.images.size())
    document_.fail(
        fmt::format("a texture uses image {}, but the file has {}; export the model "
                    "again",
                    image, document_.images.size()));
  const auto index = static_cast<std::size_t>(image);
  const auto next = static_cast<std::uint32_t>(images_.size());
  const auto [entry, is_new] = loaded_.try_emplace(index, next);
  if (!is_new) return entry->second;
  const std::string& name = document_.images[index].name;
  const std::string bytes = bytesOf(index);
  try {
    const RgbaImageSize size = rgbaSizeOf(bytes);
    pixels_ += static_cast<std::size_t>(size.width) * static_cast<std::size_t>(size.height);
    if (pixels_ > kMostPixelsOfAll)
      document_.fail(fmt::format("the pictures have more than {} pixels; make them smaller",
                                 grouped(kMostPixelsOfAll)));
    RgbaImage decoded = decodeRgba(bytes);
    images_.push_back({name, decoded.width, decoded.height, std::move(decoded.bytes)});
  } catch (const Error& error) {
    if (pixels_ > kMostPixelsOfAll) throw;
    document_.fail(fmt::format("image {} ({}): {}", image, printable(name), error.what()));
  }
  return next;
}

}  // namespace glimt
