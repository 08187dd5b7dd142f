// Models as .gltf, .bin and .png files.
#pragma once

#include <filesystem>

#include "assets/generate/model/model.h"

namespace glimt::assets {

// Writes FOLDER/NAME.gltf, NAME.bin and the pictures. The same model gives the same bytes.
// Errors: usage, for a part whose material is not there; failed, for files.
void writeGltf(const std::filesystem::path& folder, const std::string& name, const Model& model);

}  // namespace glimt::assets
