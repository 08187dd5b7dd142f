// Materials and variants in glTF's JSON.
#pragma once

#include <map>
#include <nlohmann/json.hpp>
#include <string>

#include "assets/generate/model/model.h"

namespace glimt::assets {

using Json = nlohmann::ordered_json;

// The list of a model's materials, those of its variants included, and where each one is.
class GltfMaterials {
 public:
  explicit GltfMaterials(const Model& model);

  const Json& list() const { return list_; }
  // Of KHR_materials_variants, in the file's root: the names.
  Json variantNames() const;

  // Errors: usage, where there is no such material.
  int indexOf(const std::string& material) const;
  // Of KHR_materials_variants, in a primitive: empty where no variant changes the material.
  Json mappings(const std::string& material) const;

 private:
  int added(const std::string& name, const Material& material);

  const Model& model_;
  Json list_ = Json::array();
  std::map<std::string, int> indices_;
  std::map<std::string, std::vector<int>> of_variants_;  // -1: the variant leaves it as it is
};

// Extensions that the list uses, sorted by name.
std::vector<std::string> extensionsOf(const Json& materials);

}  // namespace glimt::assets
