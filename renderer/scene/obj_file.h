// Wavefront OBJ.
#pragma once

#include <filesystem>

#include "renderer/scene/scene.h"

namespace glimt {

// The model alone: camera, light and checks come later. Indices are in range; values are as in the
// file, and may be NaN or infinite where the file has no number. Polygons are cut into triangles.
// Errors: input, "PATH:LINE: what; what to do".
Scene readObjFile(const std::filesystem::path& path);

}  // namespace glimt
