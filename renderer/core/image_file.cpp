#include "renderer/core/image_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <string>

#include "renderer/core/error.h"
#include "renderer/core/file.h"
#include "renderer/core/image_codecs.h"
#include "renderer/core/wording.h"

namespace glimt {
namespace {

namespace fs = std::filesystem;

// A PFM of as many pixels as are read at most. With the picture beside it that is below 2 GiB.
constexpr std::uintmax_t kLargestFile = 12 * static_cast<std::uintmax_t>(kMostPixels) + 4096;

std::string lowerExtension(const fs::path& path) {
  std::string extension = path.extension().string();
  std::transform(extension.begin(), extension.end(), extension.begin(),
                 [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c + 32) : c; });
  return extension;
}

Image decode(ImageFormat format, std::string_view bytes) {
  switch (format) {
    case ImageFormat::png:
      return decodePng(bytes);
    case ImageFormat::exr:
      return decodeExr(bytes);
    case ImageFormat::pfm:
      return decodePfm(bytes);
    case ImageFormat::hdr:
      return decodeHdr(bytes);
  }
  return {};
}

std::optional<ImageFormat> formatNamed(const std::string& extension) {
  if (extension == ".png") return ImageFormat::png;
  if (extension == ".exr") return ImageFormat::exr;
  if (extension == ".pfm") return ImageFormat::pfm;
  if (extension == ".hdr") return ImageFormat::hdr;
  return std::nullopt;
}

[[noreturn]] void wrongKind(const fs::path& path, const char* what) {
  throw Error(ErrorKind::usage, fmt::format("{}: {}", printable(path.string()), what));
}

}  // namespace

void demandPlausibleSize(long long width, long long height, std::size_t bytes,
                         double most_pixels_per_byte) {
  if (width <= 0 || height <= 0) {
    throw Error(ErrorKind::input, "the picture has no pixels; write the picture again");
  }
  const double pixels = static_cast<double>(width) * static_cast<double>(height);
  if (pixels > static_cast<double>(kMostPixels)) {
    throw Error(ErrorKind::input,
                fmt::format("the picture claims {}x{} pixels; at most {} pixels are read", width,
                            height, grouped(kMostPixels)));
  }
  if (pixels > most_pixels_per_byte * static_cast<double>(bytes)) {
    throw Error(ErrorKind::input,
                fmt::format("the picture claims {}x{} pixels but the file ends too early; write "
                            "the picture again",
                            width, height));
  }
}

bool isImageFile(const fs::path& path) {
  return formatNamed(lowerExtension(path)).has_value();
}

ImageFormat imageFormatOf(const fs::path& path) {
  const std::optional<ImageFormat> format = formatNamed(lowerExtension(path));
  if (!format) wrongKind(path, "unknown kind of picture; use .png, .exr, .pfm or .hdr");
  return *format;
}

Image readImage(const fs::path& path) {
  const ImageFormat format = imageFormatOf(path);
  const std::string bytes = readFile(path, kLargestFile);
  try {
    return decode(format, bytes);
  } catch (const Error& error) {
    throw Error(error.kind(), fmt::format("{}: {}", printable(path.string()), error.what()));
  } catch (const std::bad_alloc&) {
    throw Error(ErrorKind::input, fmt::format("{}: the picture needs more memory than there is; "
                                              "make it smaller",
                                              printable(path.string())));
  }
}

void writeImage(const fs::path& path, const Image& image) {
  switch (imageFormatOf(path)) {
    case ImageFormat::exr:
      return writeFile(path, encodeExr(image));
    case ImageFormat::pfm:
      return writeFile(path, encodePfm(image));
    case ImageFormat::hdr:
      return writeFile(path, encodeHdr(image));
    case ImageFormat::png:
      break;
  }
  wrongKind(path, "a PNG holds display values, not radiance; use .exr, .pfm or .hdr");
}

void writeDisplayImage(const fs::path& path, const DisplayImage& image) {
  if (imageFormatOf(path) != ImageFormat::png) {
    wrongKind(path, "display values are written as PNG; use .png");
  }
  writeFile(path, encodePng(image));
}

}  // namespace glimt
