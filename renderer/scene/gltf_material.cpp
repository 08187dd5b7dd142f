#include "renderer/scene/gltf_material.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "renderer/core/wording.h"
#include "renderer/scene/gltf_extensions.h"
#include "renderer/scene/gltf_texture.h"

namespace glimt {
namespace {

// A short name for messages, which may come from anyone.
std::string shownName(const std::string& name) {
  return printable(std::string_view(name).substr(0, 60));
}

Vec3 colorOf(const std::vector<double>& numbers, const Vec3& otherwise) {
  if (numbers.size() < 3) return otherwise;
  return {numbers[0], numbers[1], numbers[2]};
}

AlphaMode alphaModeOf(const std::string& mode) {
  if (mode == "MASK") return AlphaMode::mask;
  return mode == "BLEND" ? AlphaMode::blend : AlphaMode::opaque;
}

// What materials ask for and the renderer has not.
struct LeftOut {
  std::vector<std::string> textures;        // pictures that are not there, or a third set
  std::vector<std::string> specular_color;  // KHR_materials_specular with a colour
  std::vector<std::string> specular_texture;
  std::vector<std::string> clearcoat_normal;
};

class MaterialReader {
 public:
  MaterialReader(const GltfDocument& document, GltfImages& images, LeftOut& left_out)
      : document_(document), images_(images), left_out_(left_out) {}

  Material read(const tinygltf::Material& given, std::size_t index);

 private:
  void readBase(const tinygltf::Material& given);
  void readSurface(const tinygltf::ExtensionMap& extensions);
  void readInside(const tinygltf::ExtensionMap& extensions);
  void readCoats(const tinygltf::ExtensionMap& extensions);

  TextureUse use(const GltfTextureInfo& info) {
    return textureUseOf(document_, info, images_, left_out_.textures, shownName(material_.name));
  }
  template <typename Info>
  TextureUse useOf(const Info& info) {
    return use({info.index, info.texCoord, &info.extensions});
  }
  TextureUse useOf(const tinygltf::Value& extension, const char* key) {
    tinygltf::ExtensionMap extensions;
    return use(textureInfoOf(extension, key, extensions));
  }
  static float factor(const tinygltf::Value& extension, const char* key, double otherwise) {
    return static_cast<float>(numberOf(extension, key).value_or(otherwise));
  }
  void note(std::vector<std::string>& names) { names.push_back(shownName(material_.name)); }

  const GltfDocument& document_;
  GltfImages& images_;
  LeftOut& left_out_;
  Material material_;
};

Material MaterialReader::read(const tinygltf::Material& given, std::size_t index) {
  material_ = {};
  material_.name = given.name.empty() ? fmt::format("material {}", index) : given.name;
  readBase(given);
  readSurface(given.extensions);
  readInside(given.extensions);
  readCoats(given.extensions);
  return material_;
}

void MaterialReader::readBase(const tinygltf::Material& given) {
  const tinygltf::PbrMetallicRoughness& pbr = given.pbrMetallicRoughness;
  material_.base_color = colorOf(pbr.baseColorFactor, Vec3(1));
  if (pbr.baseColorFactor.size() > 3) material_.alpha = static_cast<float>(pbr.baseColorFactor[3]);
  material_.metallic = static_cast<float>(pbr.metallicFactor);
  material_.roughness = static_cast<float>(pbr.roughnessFactor);
  material_.specular = 1;
  // glTF means by it that back faces are there at all. In glimt a surface always has two sides, as
  // what casts a shadow has, and this tells whether the back emits too.
  material_.double_sided = given.doubleSided;
  material_.emission = colorOf(given.emissiveFactor, Vec3(0));
  if (const auto* e = extensionOf(given.extensions, "KHR_materials_emissive_strength"))
    material_.emission *= factor(*e, "emissiveStrength", 1);
  material_.unlit = given.extensions.contains("KHR_materials_unlit");
  material_.alpha_mode = alphaModeOf(given.alphaMode);
  material_.alpha_cutoff = static_cast<float>(given.alphaCutoff);
  material_.base_color_texture = useOf(pbr.baseColorTexture);
  material_.metallic_roughness_texture = useOf(pbr.metallicRoughnessTexture);
  material_.emission_texture = useOf(given.emissiveTexture);
  material_.normal_texture = useOf(given.normalTexture);
  material_.normal_scale = static_cast<float>(given.normalTexture.scale);
  // The occlusion texture is an estimate of shadows, which a path tracer casts itself.
}

void MaterialReader::readSurface(const tinygltf::ExtensionMap& extensions) {
  if (const auto* e = extensionOf(extensions, "KHR_materials_ior"))
    material_.ior = factor(*e, "ior", 1.5);
  if (const auto* e = extensionOf(extensions, "KHR_materials_specular")) {
    material_.specular = factor(*e, "specularFactor", 1);
    if (colorOf(numbersOf(*e, "specularColorFactor", 3), Vec3(1)) != Vec3(1))
      note(left_out_.specular_color);
    if (e->Has("specularTexture") || e->Has("specularColorTexture"))
      note(left_out_.specular_texture);
  }
}

void MaterialReader::readInside(const tinygltf::ExtensionMap& extensions) {
  const auto* const transmission = extensionOf(extensions, "KHR_materials_transmission");
  if (transmission != nullptr) {
    material_.transmission = factor(*transmission, "transmissionFactor", 0);
    material_.transmission_texture = useOf(*transmission, "transmissionTexture");
  }
  const auto* const volume = extensionOf(extensions, "KHR_materials_volume");
  // The thickness is an estimate for renderers that do not follow light through the surface; all
  // that it says here is whether there is an inside.
  const bool has_inside = volume != nullptr && factor(*volume, "thicknessFactor", 0) > 0;
  material_.thin_walled = material_.transmission > 0 && !has_inside;
  if (!has_inside) return;
  const float distance = factor(*volume, "attenuationDistance", 0);
  material_.attenuation_distance = std::isfinite(distance) ? std::max(distance, 0.0f) : 0;
  material_.attenuation_color =
      glm::clamp(colorOf(numbersOf(*volume, "attenuationColor", 3), Vec3(1)), 0.0f, 1.0f);
}

void MaterialReader::readCoats(const tinygltf::ExtensionMap& extensions) {
  if (const auto* e = extensionOf(extensions, "KHR_materials_clearcoat")) {
    material_.clearcoat = factor(*e, "clearcoatFactor", 0);
    material_.clearcoat_roughness = factor(*e, "clearcoatRoughnessFactor", 0);
    material_.clearcoat_texture = useOf(*e, "clearcoatTexture");
    material_.clearcoat_roughness_texture = useOf(*e, "clearcoatRoughnessTexture");
    if (material_.clearcoat > 0 && e->Has("clearcoatNormalTexture"))
      note(left_out_.clearcoat_normal);
  }
  if (const auto* e = extensionOf(extensions, "KHR_materials_sheen")) {
    material_.sheen_color = colorOf(numbersOf(*e, "sheenColorFactor", 3), Vec3(0));
    material_.sheen_roughness = factor(*e, "sheenRoughnessFactor", 0);
    material_.sheen_color_texture = useOf(*e, "sheenColorTexture");
    material_.sheen_roughness_texture = useOf(*e, "sheenRoughnessTexture");
  }
}

// What the specification gives to primitives without a material.
Material defaultMaterial() {
  Material material;
  material.name = "default";
  material.base_color = Vec3(1);
  material.metallic = 1;
  material.specular = 1;
  material.double_sided = false;
  return material;
}

void warn(Scene& scene, const char* what, std::vector<std::string> names) {
  if (names.empty()) return;
  names.erase(std::unique(names.begin(), names.end()), names.end());
  scene.warnings.push_back(fmt::format("{}: {}", what, listed(names)));
}

}  // namespace

void readGltfMaterials(const GltfDocument& document, Scene& scene) {
  GltfImages images(document, scene.images);
  LeftOut left_out;
  MaterialReader reader(document, images, left_out);
  const auto& given = document.model.materials;
  scene.materials.reserve(given.size() + 1);
  for (std::size_t i = 0; i < given.size(); ++i)
    scene.materials.push_back(reader.read(given[i], i));
  scene.materials.push_back(defaultMaterial());
  warn(scene, "textures without a PNG or JPEG, or of a third set of coordinates, are left out of",
       left_out.textures);
  warn(scene, "the colour of specular reflection is taken for white in", left_out.specular_color);
  warn(scene, "specularTexture and specularColorTexture are left out of",
       left_out.specular_texture);
  warn(scene, "clearcoatNormalTexture is left out of", left_out.clearcoat_normal);
}

}  // namespace glimt
