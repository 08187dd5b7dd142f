// Pictures for surfaces.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "renderer/scene/scene.h"

namespace glimt {

// PNG, JPEG, BMP, TGA and what else stb_image reads. `name` is for messages. Errors: input.
TextureImage decodeTextureImage(std::string_view bytes, const std::string& name);

// The same from a file. Errors: input, "PATH: what; what to do".
TextureImage readTextureImage(const std::filesystem::path& path);

// Half as wide and high, rounded up. Colours are averaged as if they were squares of light, which
// is close to sRGB.
TextureImage halved(const TextureImage& image);

}  // namespace glimt
