#include "renderer/scene/mtl_file.h"

#include <fmt/format.h>
#include <tiny_obj_loader.h>

#include <map>
#include <sstream>

#include "renderer/core/error.h"
#include "renderer/core/file.h"
#include "renderer/core/wording.h"
#include "renderer/scene/obj_lines.h"

namespace glimt {
namespace {

constexpr std::uintmax_t kLargestMtl = 64 << 20;
// tinyobjloader takes more than a thousand bytes for each.
constexpr std::size_t kMostMaterials = 1 << 16;

// tinyobjloader takes a material that gives no Kd for a black one. So every material begins with
// a Kd that no file gives; one that the file gives comes later and wins.
std::string withDefaultColor(std::string_view text, const std::string& path) {
  ObjLines lines(text);
  std::istream stream(&lines);
  std::string out;
  std::size_t materials = 0;
  for (std::string line; std::getline(stream, line);) {
    out += line + "\n";
    if (!line.starts_with("newmtl")) continue;
    out += "Kd -1 -1 -1\n";
    if (++materials <= kMostMaterials) continue;
    throw Error(ErrorKind::input, fmt::format("{}:{}: more than {} materials; use fewer", path,
                                              lines.number(), grouped(kMostMaterials)));
  }
  return out;
}

Vec3 vectorOf(const tinyobj::real_t (&values)[3]) {
  return {values[0], values[1], values[2]};
}

// Without a Kd: grey, or what the picture says.
Vec3 baseColorOf(const tinyobj::material_t& m) {
  const Vec3 given = vectorOf(m.diffuse);
  if (given != Vec3(-1)) return given;
  return m.diffuse_texname.empty() ? Material().base_color : Vec3(1);
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

// By its illumination model.
bool isGlass(const tinyobj::material_t& m) {
  return m.illum == 4 || m.illum == 6 || m.illum == 7 || m.illum == 9;
}

// What is dissolved lets light pass without bending it. Nothing is left at 0, which many files say
// where they mean 1.
void dissolve(const tinyobj::material_t& m, Material& material) {
  if (isGlass(m) || !(m.dissolve > 0 && m.dissolve < 1)) return;
  material.alpha = m.dissolve;
  material.alpha_mode = AlphaMode::blend;
}

bool isBeyondLambert(const tinyobj::material_t& m) {
  return m.specular[0] > 0 || m.specular[1] > 0 || m.specular[2] > 0 || m.illum >= 3 ||
         m.metallic > 0 || m.sheen > 0 || m.clearcoat_thickness > 0 ||
         (isGlass(m) && m.dissolve < 1);
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
  std::istringstream text(withDefaultColor(demandText(bytes, shown_path), shown_path));
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
    out.material.name = name;
    out.material.base_color = baseColorOf(m);
    out.material.emission = vectorOf(m.emission);
    if (!m.emissive_texname.empty() && out.material.emission == Vec3(0))
      out.material.emission = Vec3(1);
    dissolve(m, out.material);
    out.textures = texturesOf(m);
    out.has_other_textures = hasOtherTextures(m);
    out.beyond_lambert = isBeyondLambert(m);
    materials.push_back(std::move(out));
  }
  return materials;
}

}  // namespace glimt
