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
  Material material;  // values as in the file, unchecked; Kd 0.8 where it gives none
  MtlTextures textures;
  bool has_other_textures = false;  // names pictures of other kinds
  bool beyond_lambert = false;      // asks for gloss, metal or glass
};

// Errors: input, for what cannot be read or is no text.
std::vector<MtlMaterial> readMtlFile(const std::filesystem::path& path);

}  // namespace glimt
