#include "renderer/scene/gltf_variants.h"

#include "renderer/scene/gltf_extensions.h"

namespace glimt {
namespace {

constexpr const char* kVariants = "KHR_materials_variants";

const tinygltf::Value* arrayOf(const tinygltf::ExtensionMap& extensions, const char* key) {
  const tinygltf::Value* const extension = extensionOf(extensions, kVariants);
  const tinygltf::Value* const array = extension == nullptr ? nullptr : memberOf(*extension, key);
  return array != nullptr && array->IsArray() ? array : nullptr;
}

bool holds(const tinygltf::Value& numbers, std::size_t number) {
  for (int i = 0; i < static_cast<int>(numbers.ArrayLen()); ++i)
    if (numbers.Get(i).IsInt() && numbers.Get(i).Get<int>() == static_cast<int>(number))
      return true;
  return false;
}

}  // namespace

std::vector<std::string> variantNames(const tinygltf::Model& model) {
  std::vector<std::string> names;
  const tinygltf::Value* const variants = arrayOf(model.extensions, "variants");
  if (variants == nullptr) return names;
  for (int i = 0; i < static_cast<int>(variants->ArrayLen()); ++i) {
    const tinygltf::Value* const name = memberOf(variants->Get(i), "name");
    names.push_back(name != nullptr && name->IsString() ? name->Get<std::string>() : "");
  }
  return names;
}

int materialOf(const tinygltf::Primitive& primitive, std::optional<std::size_t> variant) {
  const tinygltf::Value* const mappings = arrayOf(primitive.extensions, "mappings");
  if (!variant || mappings == nullptr) return primitive.material;
  for (int i = 0; i < static_cast<int>(mappings->ArrayLen()); ++i) {
    const tinygltf::Value& mapping = mappings->Get(i);
    const tinygltf::Value* const variants = memberOf(mapping, "variants");
    if (variants != nullptr && variants->IsArray() && holds(*variants, *variant))
      return indexOf(mapping, "material").value_or(-1);
  }
  return primitive.material;
}

}  // namespace glimt
