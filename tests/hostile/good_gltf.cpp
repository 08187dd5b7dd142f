// Small glTF files in which most of what glimt reads of the format comes up once.
#include "tests/hostile/good_files.h"
#include "tests/hostile/good_png.h"
#include "tests/unit/gltf_text.h"

namespace glimt {
namespace {

using Json = GltfText::Json;

void addTexture(GltfText& gltf) {
  const std::string png = goodPng(4, 3, {8, 6, false});
  gltf.root["images"] = {{{"uri", "data:image/png;base64," + base64(png)}},
                         {{"bufferView", gltf.view(png)}, {"mimeType", "image/png"}}};
  gltf.root["samplers"] = {{{"wrapS", 33071}, {"wrapT", 33648}, {"magFilter", 9728}}};
  gltf.root["textures"] = {{{"source", 0}, {"sampler", 0}}, {{"source", 1}}};
}

void addMaterials(GltfText& gltf) {
  const Json transform = {{"KHR_texture_transform", {{"offset", {1, 2}}, {"rotation", 0.5}}}};
  gltf.root["materials"] = {
      {{"name", "all"},
       {"alphaMode", "MASK"},
       {"emissiveFactor", {1, 0.5, 0}},
       {"pbrMetallicRoughness",
        {{"baseColorFactor", {0.5, 0.5, 0.5, 1}},
         {"metallicFactor", 0},
         {"baseColorTexture", {{"index", 0}, {"extensions", transform}}}}},
       {"normalTexture", {{"index", 1}, {"texCoord", 1}, {"scale", 0.5}}},
       {"extensions",
        {{"KHR_materials_clearcoat", {{"clearcoatFactor", 0.5}}},
         {"KHR_materials_ior", {{"ior", 1.25}}}}}},
      {{"name", "glass"},
       {"extensions",
        {{"KHR_materials_transmission", {{"transmissionFactor", 1}}},
         {"KHR_materials_volume", {{"thicknessFactor", 1}, {"attenuationDistance", 2}}}}}}};
}

void addMesh(GltfText& gltf) {
  const std::vector<float> square = {0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 1, 0};
  const std::vector<float> normals = {0, 0, 1, 0, 0, 1, 0, 0, 1, 0, 0, 1};
  Json attributes;
  attributes["POSITION"] = gltf.floats(square, "VEC3", 3);
  attributes["NORMAL"] = gltf.floats(normals, "VEC3", 3);
  attributes["COLOR_0"] = gltf.floats(square, "VEC3", 3);
  attributes["TEXCOORD_0"] = gltf.accessor(
      gltf.view(bytesOf(std::vector<std::uint16_t>{0, 0, 65535, 0, 0, 1, 2, 3})), 5123, 4, "VEC2");
  gltf.root["accessors"].back()["normalized"] = true;
  const Json mappings = {{{"material", 1}, {"variants", {0}}}};
  gltf.mesh({{"attributes", attributes},
             {"indices", gltf.shorts({0, 1, 2, 1, 3, 2})},
             {"material", 0},
             {"extensions", {{"KHR_materials_variants", {{"mappings", mappings}}}}}});
  const int indices = gltf.view(bytesOf(std::vector<std::uint16_t>{3}));
  const int values = gltf.view(bytesOf(std::vector<float>{2, 2, 1}));
  gltf.root["accessors"][0]["sparse"] = {
      {"count", 1},
      {"indices", {{"bufferView", indices}, {"componentType", 5123}}},
      {"values", {{"bufferView", values}}}};
}

void addNodes(GltfText& gltf) {
  gltf.root["extensions"] = {
      {"KHR_lights_punctual",
       {{"lights", {{{"type", "spot"}, {"spot", {{"outerConeAngle", 1}}}}}}}},
      {"KHR_materials_variants", {{"variants", {{{"name", "day"}}}}}}};
  gltf.root["cameras"] = {
      {{"type", "perspective"}, {"perspective", {{"yfov", 1}, {"znear", 0.1}}}}};
  const int moved = gltf.floats({0, 0, 0, 0, 0, -7}, "VEC3", 3);
  gltf.append("nodes", {{"children", {1, 2, 3}}, {"scale", {2, -2, 2}}});
  gltf.append(
      "nodes",
      {{"mesh", 0},
       {"extensions", {{"EXT_mesh_gpu_instancing", {{"attributes", {{"TRANSLATION", moved}}}}}}}});
  gltf.append("nodes", {{"camera", 0}, {"translation", {0, 0, 5}}});
  gltf.append("nodes", {{"matrix", {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 3, 0, 1}},
                        {"extensions", {{"KHR_lights_punctual", {{"light", 0}}}}}});
  gltf.root["scenes"] = {{{"nodes", {0}}}};
  gltf.root["scene"] = 0;
}

}  // namespace

std::vector<GoodFile> goodGltfs() {
  GltfText whole;
  addMesh(whole);
  addTexture(whole);
  addMaterials(whole);
  addNodes(whole);
  GltfText least;
  least.triangle();
  least.append("nodes", {{"mesh", 0}});
  return {{"gltf", "whole.gltf", whole.text()},
          {"gltf", "least.gltf", least.text()},
          {"glb", "whole.glb", asGlb(whole)},
          {"glb", "least.glb", asGlb(least)}};
}

}  // namespace glimt
