// Wavefront MTL: the materials beside an OBJ.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "renderer/scene/scene.h"

namespace glimt {

struct MtlTexture {
  std::string file;  // as the MTL names it; empty: none
  TextureUse use;    // without the image
};

// A material's pictures, one for each number that they vary.
struct MtlTextures {
  MtlTexture base_color;
  MtlTexture alpha;
  MtlTexture roughness;
  MtlTexture metallic;
  MtlTexture emission;
  MtlTexture normal;
  bool normal_may_be_heights = false;  // named as a bump map, which may be either
  float normal_scale = 1;
};

struct MtlMaterial {
  Material material;  // as docs/materials.md says, unchecked; Kd 0.8 where the file gives none
  MtlTextures textures;
  bool has_other_textures = false;  // names pictures of other kinds
};

// Errors: input, for what cannot be read or is no text.
std::vector<MtlMaterial> readMtlFile(const std::filesystem::path& path);

}  // namespace glimt
