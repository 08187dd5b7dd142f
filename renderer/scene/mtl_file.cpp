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

// tinyobjloader takes a material that gives no Kd for a black one, and does not tell what else is
// not given. So every material begins with these; what the file gives comes later and wins.
constexpr const char* kDefaults =
    "Kd 0.8 0.8 0.8\nNs -1\nNi -1\nTf -1 -1 -1\nPr -1\nPm -1\nillum 2\n";

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

bool isTextured(const tinyobj::material_t& m) {
  for (const std::string* name :
       {&m.ambient_texname, &m.diffuse_texname, &m.specular_texname, &m.specular_highlight_texname,
        &m.bump_texname, &m.displacement_texname, &m.alpha_texname, &m.reflection_texname,
        &m.roughness_texname, &m.metallic_texname, &m.sheen_texname, &m.emissive_texname,
        &m.normal_texname}) {
    if (!name->empty()) return true;
  }
  return false;
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
    out.textured = isTextured(m);
    materials.push_back(std::move(out));
  }
  return materials;
}

}  // namespace glimt
