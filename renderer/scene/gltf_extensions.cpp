#include "renderer/scene/gltf_extensions.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <set>
#include <string_view>

#include "renderer/core/wording.h"

namespace glimt {
namespace {

constexpr std::array<std::string_view, 14> kKnown = {"EXT_mesh_gpu_instancing",
                                                     "KHR_draco_mesh_compression",
                                                     "KHR_lights_punctual",
                                                     "KHR_materials_clearcoat",
                                                     "KHR_materials_emissive_strength",
                                                     "KHR_materials_ior",
                                                     "KHR_materials_sheen",
                                                     "KHR_materials_specular",
                                                     "KHR_materials_transmission",
                                                     "KHR_materials_unlit",
                                                     "KHR_materials_variants",
                                                     "KHR_materials_volume",
                                                     "KHR_mesh_quantization",
                                                     "KHR_texture_transform"};

// Sorted, each once.
std::vector<std::string> unknownOf(const std::vector<std::string>& names) {
  std::set<std::string> unknown;
  for (const std::string& name : names)
    if (std::find(kKnown.begin(), kKnown.end(), name) == kKnown.end())
      unknown.insert(printable(name));
  return {unknown.begin(), unknown.end()};
}

}  // namespace

void checkGltfExtensions(const std::vector<std::string>& required,
                         const std::vector<std::string>& used, GltfDocument& document) {
  if (const std::vector<std::string> unknown = unknownOf(required); !unknown.empty())
    document.fail(fmt::format("the file requires {}, which glimt does not read; export it without",
                              listed(unknown)));
  if (const std::vector<std::string> unknown = unknownOf(used); !unknown.empty())
    document.warnings.push_back(
        fmt::format("extensions that glimt does not read are ignored: {}", listed(unknown)));
}

const tinygltf::Value* extensionOf(const tinygltf::ExtensionMap& extensions, const char* name) {
  const auto found = extensions.find(name);
  return found != extensions.end() && found->second.IsObject() ? &found->second : nullptr;
}

const tinygltf::Value* memberOf(const tinygltf::Value& object, const char* key) {
  return object.IsObject() && object.Has(key) ? &object.Get(key) : nullptr;
}

std::optional<double> numberOf(const tinygltf::Value& object, const char* key) {
  const tinygltf::Value* const value = memberOf(object, key);
  if (value == nullptr || !value->IsNumber()) return {};
  return value->GetNumberAsDouble();
}

std::optional<int> indexOf(const tinygltf::Value& object, const char* key) {
  const tinygltf::Value* const value = memberOf(object, key);
  if (value == nullptr || !value->IsInt()) return {};
  return value->Get<int>();
}

std::vector<double> numbersOf(const tinygltf::Value& object, const char* key, std::size_t size) {
  const tinygltf::Value* const value = memberOf(object, key);
  if (value == nullptr || !value->IsArray() || value->ArrayLen() != size) return {};
  std::vector<double> numbers;
  for (int i = 0; i < static_cast<int>(size); ++i) {
    if (!value->Get(i).IsNumber()) return {};
    numbers.push_back(value->Get(i).GetNumberAsDouble());
  }
  return numbers;
}

}  // namespace glimt
