#include "renderer/scene/mtl_file.h"

#include <fmt/format.h>
#include <tiny_obj_loader.h>

#include <map>
#include <sstream>

#include "renderer/core/error.h"
#include "renderer/core/file.h"
#include "renderer/core/wording.h"
#include "renderer/scene/mtl_material.h"
#include "renderer/scene/obj_lines.h"

namespace glimt {
namespace {

constexpr std::uintmax_t kLargestMtl = 64 << 20;
// tinyobjloader takes more than a thousand bytes for each.
constexpr std::size_t kMostMaterials = 1 << 16;

// tinyobjloader does not tell what is not given. So every material begins with these; what the file
// gives comes later and wins.
constexpr const char* kDefaults = "Kd -1 -1 -1\nNs -1\nNi -1\nTf -1 -1 -1\nPr -1\nPm -1\nillum 2\n";

std::string withDefaults(std::string_view text, const std::string& path) {
  ObjLines lines(text);
  std::istream stream(&lines);
  std::string out;
  std::size_t materials = 0;
  for (std::string line; std::getline(stream, line);) {
    out += line + "\n";
    if (!line.starts_with("newmtl")) continue;
    out += kDefaults;
    if (++materials <= kMostMaterials) continue;
    throw Error(ErrorKind::input, fmt::format("{}:{}: more than {} materials; use fewer", path,
                                              lines.number(), grouped(kMostMaterials)));
  }
  return out;
}

bool hasOtherTextures(const tinyobj::material_t& m) {
  for (const std::string* name :
       {&m.ambient_texname, &m.specular_texname, &m.specular_highlight_texname,
        &m.displacement_texname, &m.reflection_texname, &m.sheen_texname}) {
    if (!name->empty()) return true;
  }
  return false;
}

// The option -o moves the picture and -s repeats it, with v running up; TextureUse's v runs down.
MtlTexture textureOf(const std::string& file, const tinyobj::texture_option_t& options) {
  MtlTexture texture;
  texture.file = file;
  TextureUse& use = texture.use;
  use.scale = Vec2(options.scale[0], options.scale[1]);
  use.offset = Vec2(options.origin_offset[0], 1 - options.scale[1] - options.origin_offset[1]);
  if (options.clamp) use.wrap_u = use.wrap_v = Wrap::clamp;
  return texture;
}

MtlTextures texturesOf(const tinyobj::material_t& m) {
  MtlTextures textures;
  textures.base_color = textureOf(m.diffuse_texname, m.diffuse_texopt);
  textures.alpha = textureOf(m.alpha_texname, m.alpha_texopt);
  textures.roughness = textureOf(m.roughness_texname, m.roughness_texopt);
  textures.metallic = textureOf(m.metallic_texname, m.metallic_texopt);
  textures.emission = textureOf(m.emissive_texname, m.emissive_texopt);
  const bool bump = m.normal_texname.empty();
  const tinyobj::texture_option_t& options = bump ? m.bump_texopt : m.normal_texopt;
  textures.normal = textureOf(bump ? m.bump_texname : m.normal_texname, options);
  textures.normal_may_be_heights = bump;
  textures.normal_scale = options.bump_multiplier;
  return textures;
}

std::string withoutBlanksAround(const std::string& name) {
  const std::size_t first = name.find_first_not_of(" \t");
  if (first == std::string::npos) return {};
  return name.substr(first, name.find_last_not_of(" \t") - first + 1);
}

}  // namespace

std::vector<MtlMaterial> readMtlFile(const std::filesystem::path& path) {
  const std::string bytes = readFile(path, kLargestMtl);
  const std::string shown_path = printable(path.string());
  std::istringstream text(withDefaults(demandText(bytes, shown_path), shown_path));
  std::map<std::string, int> index_of_name;
  std::vector<tinyobj::material_t> parsed;
  std::string ignored_warnings;
  std::string ignored_errors;
  tinyobj::LoadMtl(&index_of_name, &parsed, &text, &ignored_warnings, &ignored_errors);

  std::vector<MtlMaterial> materials;
  for (const tinyobj::material_t& m : parsed) {
    const std::string name = withoutBlanksAround(m.name);
    if (name.empty()) continue;
    MtlMaterial out;
    out.material = materialOfMtl(m);
    out.material.name = name;
    out.textures = texturesOf(m);
    out.has_other_textures = hasOtherTextures(m);
    materials.push_back(std::move(out));
  }
  return materials;
}

}  // namespace glimt
