// What the materials and textures of a glTF file become.
#include <catch2/catch.hpp>

#include "renderer/core/image_codecs.h"
#include "renderer/scene/load_scene.h"
#include "tests/unit/expect_error.h"
#include "tests/unit/gltf_text.h"
#include "tests/unit/temporary_folder.h"

using namespace glimt;
using Json = GltfText::Json;

namespace {

// Of a triangle that has that material.
Scene loadWith(const Json& material, GltfText gltf = {}) {
  gltf.root["materials"] = {material};
  gltf.triangle({{"material", 0}});
  gltf.append("nodes", {{"mesh", 0}});
  const TemporaryFolder folder;
  return loadScene(folder.write("model.gltf", gltf.text()));
}

Material materialWith(const char* extension, const Json& value) {
  return loadWith({{"extensions", {{extension, value}}}}).materials.at(0);
}

std::string picture(std::uint8_t red) {
  return encodePng(DisplayImage{1, 1, {red, 2, 3}});
}

bool warns(const Scene& scene, const char* of) {
  return std::any_of(scene.warnings.begin(), scene.warnings.end(),
                     [&](const std::string& text) { return text.find(of) != std::string::npos; });
}

}  // namespace

TEST_CASE("a glTF material that says nothing is a rough white metal, as the format defines it") {
  const Scene scene = loadWith(Json::object());
  REQUIRE(scene.materials.size() == 1);
  const Material& material = scene.materials[0];
  CHECK(material.base_color == Vec3(1));
  CHECK(material.metallic == 1);
  CHECK(material.roughness == 1);
  CHECK(material.specular == 1);
  CHECK(material.ior == 1.5f);
  CHECK_FALSE(material.double_sided);
  CHECK(material.alpha_mode == AlphaMode::opaque);
  CHECK_FALSE(material.base_color_texture.used());
}

TEST_CASE("glTF primitives without a material get the default one") {
  GltfText gltf;
  gltf.triangle();
  gltf.append("nodes", {{"mesh", 0}});
  const TemporaryFolder folder;
  const Scene scene = loadScene(folder.write("model.gltf", gltf.text()));
  REQUIRE(scene.materials.size() == 1);
  CHECK(scene.materials[0].name == "default");
  CHECK(scene.materials[0].metallic == 1);
}

TEST_CASE("the factors of a glTF material are read") {
  const Scene scene = loadWith({{"name", "paint"},
                                {"doubleSided", true},
                                {"alphaMode", "MASK"},
                                {"alphaCutoff", 0.25},
                                {"emissiveFactor", {1, 0.5, 0}},
                                {"pbrMetallicRoughness",
                                 {{"baseColorFactor", {0.25, 0.5, 0.75, 0.125}},
                                  {"metallicFactor", 0},
                                  {"roughnessFactor", 0.5}}},
                                {"extensions",
                                 {{"KHR_materials_emissive_strength", {{"emissiveStrength", 8}}},
                                  {"KHR_materials_ior", {{"ior", 1.25}}},
                                  {"KHR_materials_specular", {{"specularFactor", 0.5}}}}}});
  const Material& material = scene.materials.at(0);
  CHECK(material.name == "paint");
  CHECK(material.double_sided);
  CHECK(material.alpha_mode == AlphaMode::mask);
  CHECK(material.alpha_cutoff == 0.25f);
  CHECK(material.emission == Vec3(8, 4, 0));
  CHECK(material.base_color == Vec3(0.25f, 0.5f, 0.75f));
  CHECK(material.alpha == 0.125f);
  CHECK(material.metallic == 0);
  CHECK(material.roughness == 0.5f);
  CHECK(material.ior == 1.25f);
  CHECK(material.specular == 0.5f);
}

TEST_CASE("glTF glass is thin-walled unless it has a thickness") {
  const Json transmission = {{"transmissionFactor", 0.75}};
  const Material thin = materialWith("KHR_materials_transmission", transmission);
  CHECK(thin.transmission == 0.75f);
  CHECK(thin.thin_walled);
  const auto volume = [&](double thickness) {
    return loadWith({{"extensions",
                      {{"KHR_materials_transmission", transmission},
                       {"KHR_materials_volume",
                        {{"thicknessFactor", thickness},
                         {"attenuationDistance", 2},
                         {"attenuationColor", {0.5, 1, 0.25}}}}}}})
        .materials.at(0);
  };
  CHECK(volume(0).thin_walled);
  CHECK(volume(0).attenuation_distance == 0);
  CHECK_FALSE(volume(1).thin_walled);
  CHECK(volume(1).attenuation_distance == 2);
  CHECK(volume(1).attenuation_color == Vec3(0.5f, 1, 0.25f));
}

TEST_CASE("coats, sheen and unlit materials of glTF are read") {
  const Material coated = materialWith(
      "KHR_materials_clearcoat", {{"clearcoatFactor", 0.5}, {"clearcoatRoughnessFactor", 0.25}});
  CHECK(coated.clearcoat == 0.5f);
  CHECK(coated.clearcoat_roughness == 0.25f);
  const Material cloth = materialWith(
      "KHR_materials_sheen", {{"sheenColorFactor", {1, 0.5, 0}}, {"sheenRoughnessFactor", 0.5}});
  CHECK(cloth.sheen_color == Vec3(1, 0.5f, 0));
  CHECK(cloth.sheen_roughness == 0.5f);
  CHECK(materialWith("KHR_materials_unlit", Json::object()).unlit);
  CHECK_FALSE(cloth.unlit);
}

TEST_CASE("what glTF materials have and glimt has not is told by their names") {
  const Scene scene = loadWith(
      {{"name", "velvet"},
       {"extensions", {{"KHR_materials_specular", {{"specularColorFactor", {1, 0, 0}}}}}}});
  CHECK(warns(scene, "taken for white in: 'velvet'"));
}

TEST_CASE("glTF textures have their picture, set, sampler and transform") {
  GltfText gltf;
  const std::string png = picture(9);
  gltf.root["images"] = {
      {{"uri", "data:image/png;base64," + base64(picture(7))}},
      {{"bufferView", gltf.view(png)}, {"mimeType", "image/png"}, {"name", "inside"}}};
  gltf.root["samplers"] = {{{"wrapS", 33071}, {"wrapT", 33648}, {"magFilter", 9728}}};
  gltf.root["textures"] = {{{"source", 1}, {"sampler", 0}}, {{"source", 0}}, {{"source", 1}}};
  const Json transform = {
      {"offset", {1, 2}}, {"rotation", 0.5}, {"scale", {3, 4}}, {"texCoord", 1}};
  const Scene scene = loadWith(
      {{"pbrMetallicRoughness",
        {{"baseColorTexture",
          {{"index", 0}, {"extensions", {{"KHR_texture_transform", transform}}}}}}},
       {"normalTexture", {{"index", 1}, {"texCoord", 1}, {"scale", 0.5}}},
       {"emissiveTexture", {{"index", 2}}},
       {"extensions",
        {{"KHR_materials_clearcoat",
          {{"clearcoatTexture",
            {{"index", 2}, {"extensions", {{"KHR_texture_transform", {{"rotation", 0.25}}}}}}}}}}}},
      gltf);
  REQUIRE(scene.images.size() == 2);
  const Material& material = scene.materials.at(0);
  const TextureUse& color = material.base_color_texture;
  REQUIRE(color.used());
  CHECK(scene.images[color.image].name == "inside");
  CHECK(scene.images[color.image].rgba == std::vector<std::uint8_t>{9, 2, 3, 255});
  CHECK(color.texcoords == 1);
  CHECK(color.wrap_u == Wrap::clamp);
  CHECK(color.wrap_v == Wrap::mirror);
  CHECK(color.nearest);
  CHECK(color.offset == Vec2(1, 2));
  CHECK(color.scale == Vec2(3, 4));
  CHECK(color.rotation == 0.5f);
  REQUIRE(material.normal_texture.used());
  CHECK(scene.images[material.normal_texture.image].rgba[0] == 7);
  CHECK(material.normal_texture.texcoords == 1);
  CHECK(material.normal_scale == 0.5f);
  CHECK(material.emission_texture.image == color.image);
  CHECK(material.emission_texture.wrap_u == Wrap::repeat);
  CHECK_FALSE(material.emission_texture.nearest);
  CHECK(material.clearcoat_texture.rotation == 0.25f);
}

TEST_CASE("glTF textures that lead nowhere are refused, or left out with a warning") {
  const Json material = {{"name", "m"},
                         {"pbrMetallicRoughness", {{"baseColorTexture", {{"index", 0}}}}}};
  const auto refusal = [&](const GltfText& gltf) {
    return messageOf(ErrorKind::input, [&] { loadWith(material, gltf); });
  };
  GltfText gltf;
  CHECK(refusal(gltf).find("texture 0") != std::string::npos);
  gltf.root["textures"] = {{{"source", 3}}};
  CHECK(refusal(gltf).find("image 3") != std::string::npos);
  gltf.root["textures"] = {{{"source", 0}}};
  gltf.root["images"] = {{{"uri", "gone.png"}}};
  CHECK(refusal(gltf).find("gone.png") != std::string::npos);
  gltf.root["images"] = {{{"uri", "data:image/png;base64," + base64("GIF89a")}}};
  CHECK(refusal(gltf).find("neither a PNG nor a JPEG") != std::string::npos);
  gltf.root["images"] = {{{"bufferView", 12}, {"mimeType", "image/png"}}};
  CHECK(refusal(gltf).find("buffer view 12") != std::string::npos);
  gltf.root["textures"] = {Json::object()};
  const Scene scene = loadWith(material, gltf);
  CHECK_FALSE(scene.materials.at(0).base_color_texture.used());
  CHECK(warns(scene, "left out of: 'm'"));
}
