// Pictures on disk: .exr .pfm .hdr hold linear radiance, .png holds display values.
#pragma once

#include <filesystem>

#include "renderer/core/image.h"

namespace glimt {

// By the file's extension (upper or lower case). Errors: usage, for an extension that is neither.
enum class ImageFormat { png, exr, pfm, hdr };
ImageFormat imageFormatOf(const std::filesystem::path& path);
bool isImageFile(const std::filesystem::path& path);  // whether it is one of them

// Reads .exr, .pfm and .hdr; a .png is decoded from sRGB to linear. Errors: input.
Image readImage(const std::filesystem::path& path);

// Writes .exr, .pfm or .hdr. The file appears complete or not at all. Errors: failed.
void writeImage(const std::filesystem::path& path, const Image& image);

// Writes .png. The file appears complete or not at all. Errors: failed.
void writeDisplayImage(const std::filesystem::path& path, const DisplayImage& image);

}  // namespace glimt
