// Wavefront MTL: the materials beside an OBJ.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "renderer/scene/scene.h"

namespace glimt {

struct MtlMaterial {
  Material material;            // values as in the file, unchecked; Kd 0.8 where it gives none
  bool textured = false;        // names pictures
  bool beyond_lambert = false;  // asks for gloss, metal or glass
};

// Errors: input, for what cannot be read or is no text.
std::vector<MtlMaterial> readMtlFile(const std::filesystem::path& path);

}  // namespace glimt
