// Wavefront MTL: the materials beside an OBJ.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "renderer/scene/scene.h"

namespace glimt {

struct MtlMaterial {
  Material material;      // as docs/materials.md says, unchecked; Kd 0.8 where the file gives none
  bool textured = false;  // names pictures
};

// Errors: input, for what cannot be read or is no text.
std::vector<MtlMaterial> readMtlFile(const std::filesystem::path& path);

}  // namespace glimt
