#include "renderer/core/image_rgba.h"

#include <fmt/format.h>
#include <stb_image.h>

#include <climits>
#include <memory>

#include "renderer/core/error.h"
#include "renderer/core/image_codecs.h"
#include "renderer/core/png_data.h"
#include "renderer/core/wording.h"

namespace glimt {
namespace {

constexpr std::string_view kPng = "\x89PNG\r\n\x1a\n";
constexpr std::string_view kJpeg = "\xff\xd8\xff";
// Deflate packs at most 1032 bytes into one, and PNG eight pixels into a byte.
constexpr double kPngPixelsPerByte = 8 * 1032;
// A progressive scan says with some two bytes that 32767 blocks of 64 pixels are even.
constexpr double kJpegPixelsPerByte = 32767 * 32;

}  // namespace

RgbaImageSize rgbaSizeOf(std::string_view bytes) {
  const bool is_png = bytes.starts_with(kPng);
  RgbaImageSize size;
  int channels = 0;
  // stb_image reads other kinds too, which glTF does not have.
  if ((!is_png && !bytes.starts_with(kJpeg)) || bytes.size() > INT_MAX ||
      !stbi_info_from_memory(reinterpret_cast<const stbi_uc*>(bytes.data()),
                             static_cast<int>(bytes.size()), &size.width, &size.height, &channels))
    throw Error(ErrorKind::input, "neither a PNG nor a JPEG picture; write it as one of these");
  demandPlausibleSize(size.width, size.height, bytes.size(),
                      is_png ? kPngPixelsPerByte : kJpegPixelsPerByte);
  return size;
}

RgbaImage decodeRgba(std::string_view bytes) {
  RgbaImageSize size = rgbaSizeOf(bytes);
  if (bytes.starts_with(kPng)) demandBoundedPngData(bytes);
  int channels = 0;
  const std::unique_ptr<stbi_uc, void (*)(void*)> values(
      stbi_load_from_memory(reinterpret_cast<const stbi_uc*>(bytes.data()),
                            static_cast<int>(bytes.size()), &size.width, &size.height, &channels,
                            4),
      stbi_image_free);
  if (!values)
    throw Error(ErrorKind::input, fmt::format("damaged picture ({}); write it again",
                                              printable(stbi_failure_reason())));
  const std::size_t count =
      4 * static_cast<std::size_t>(size.width) * static_cast<std::size_t>(size.height);
  return {size.width, size.height, {values.get(), values.get() + count}};
}

}  // namespace glimt
