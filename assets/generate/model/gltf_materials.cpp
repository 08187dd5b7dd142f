#include "assets/generate/model/gltf_materials.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "renderer/core/error.h"

namespace glimt::assets {
namespace {

// Four digits are plenty for what was chosen by eye, and keep the files readable.
double rounded(double value) {
  return std::round(value * 1e4) / 1e4;
}
Json rounded(const dvec3& v) {
  return Json::array({rounded(v.x), rounded(v.y), rounded(v.z)});
}

int pictureIndex(const Model& model, const std::string& name) {
  const auto found = std::find_if(model.pictures.begin(), model.pictures.end(),
                                  [&](const Picture& picture) { return picture.name == name; });
  if (found == model.pictures.end())
    throw Error(ErrorKind::usage,
                fmt::format("there is no picture '{}'; add it to the model", name));
  return static_cast<int>(found - model.pictures.begin());
}

void addCoats(const Material& m, Json& extensions) {
  if (m.clearcoat > 0)
    extensions["KHR_materials_clearcoat"] = {
        {"clearcoatFactor", rounded(m.clearcoat)},
        {"clearcoatRoughnessFactor", rounded(m.clearcoat_roughness)}};
  if (m.sheen_color != dvec3(0))
    extensions["KHR_materials_sheen"] = {{"sheenColorFactor", rounded(m.sheen_color)},
                                         {"sheenRoughnessFactor", rounded(m.sheen_roughness)}};
}

// glTF's factor ends at 1; the strength carries the rest.
void addEmission(const Material& m, Json& json, Json& extensions) {
  const double strength = std::max({m.emission.x, m.emission.y, m.emission.z});
  if (strength == 0) return;
  json["emissiveFactor"] = rounded(m.emission / std::max(strength, 1.0));
  if (strength > 1)
    extensions["KHR_materials_emissive_strength"] = {{"emissiveStrength", rounded(strength)}};
}

Json materialJson(const Model& model, const std::string& name, const Material& m) {
  Json pbr = {{"baseColorFactor", rounded(m.base_color)},
              {"metallicFactor", rounded(m.metallic)},
              {"roughnessFactor", rounded(m.roughness)}};
  pbr["baseColorFactor"].push_back(rounded(m.alpha));
  if (!m.base_color_picture.empty())
    pbr["baseColorTexture"] = {{"index", pictureIndex(model, m.base_color_picture)}};
  Json json = {{"name", name}, {"pbrMetallicRoughness", pbr}};
  if (!m.normal_picture.empty())
    json["normalTexture"] = {{"index", pictureIndex(model, m.normal_picture)}};
  if (m.alpha < 1) json["alphaMode"] = "BLEND";
  Json extensions;
  addEmission(m, json, extensions);
  addCoats(m, extensions);
  if (m.transmission > 0)
    extensions["KHR_materials_transmission"] = {{"transmissionFactor", rounded(m.transmission)}};
  if (!extensions.is_null()) json["extensions"] = extensions;
  return json;
}

}  // namespace

GltfMaterials::GltfMaterials(const Model& model) : model_(model) {
  for (const auto& [name, material] : model.materials) indices_[name] = added(name, material);
  for (const Variant& variant : model.variants)
    for (const auto& [name, ignored] : variant.materials) {
      indexOf(name);  // a variant of nothing would be a slip of the pen
      of_variants_[name].resize(model.variants.size(), -1);
    }
  for (std::size_t v = 0; v < model.variants.size(); ++v)
    for (const auto& [name, material] : model.variants[v].materials)
      of_variants_[name][v] = added(name + " " + model.variants[v].name, material);
}

int GltfMaterials::added(const std::string& name, const Material& material) {
  list_.push_back(materialJson(model_, name, material));
  return static_cast<int>(list_.size()) - 1;
}

Json GltfMaterials::variantNames() const {
  Json names = Json::array();
  for (const Variant& variant : model_.variants) names.push_back({{"name", variant.name}});
  return names;
}

int GltfMaterials::indexOf(const std::string& material) const {
  const auto found = indices_.find(material);
  if (found == indices_.end())
    throw Error(ErrorKind::usage,
                fmt::format("there is no material '{}'; add it to the model", material));
  return found->second;
}

Json GltfMaterials::mappings(const std::string& material) const {
  Json mappings = Json::array();
  const auto found = of_variants_.find(material);
  if (found == of_variants_.end()) return mappings;
  for (std::size_t v = 0; v < found->second.size(); ++v)
    if (found->second[v] >= 0)
      mappings.push_back({{"material", found->second[v]}, {"variants", Json::array({v})}});
  return mappings;
}

std::vector<std::string> extensionsOf(const Json& materials) {
  std::set<std::string> names;
  for (const Json& material : materials)
    if (material.contains("extensions"))
      for (const auto& [name, ignored] : material["extensions"].items()) names.insert(name);
  return {names.begin(), names.end()};
}

}  // namespace glimt::assets
