// Pictures with more than a colour: OpenEXR files of any channels, and what is noted in them.
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "renderer/core/image.h"

namespace glimt {

struct ImageLayers {
  int width = 0;
  int height = 0;
  // By their names, "R" or "albedo.R": a value for each pixel, rows from the top.
  std::map<std::string, std::vector<float>> channels;
  std::map<std::string, std::string> notes;  // attributes of type string
};

// The picture as R, G, B and, where it has one, A; with a note where it is denoised.
ImageLayers layersOf(const Image& image);

// 32-bit floats. Errors: failed.
std::string encodeLayers(const ImageLayers& layers);

// One part in scan lines, its channels floats. Errors: input, without the file's name.
ImageLayers decodeLayers(std::string_view bytes);

// With a name that ends in .exr. Errors: input.
ImageLayers readLayers(const std::filesystem::path& path);

// The file appears complete or not at all. Errors: failed.
void writeLayers(const std::filesystem::path& path, const ImageLayers& layers);

}  // namespace glimt
