#include "assets/generate/model/gltf_writer.h"

#include <cmath>
#include <string>

#include "assets/generate/geometry/surface_normals.h"
#include "assets/generate/model/gltf_materials.h"
#include "renderer/core/file.h"
#include "renderer/core/image_file.h"

namespace glimt::assets {
namespace {

constexpr int kFloat = 5126, kUnsignedInt = 5125;                 // componentType
constexpr int kArrayBuffer = 34962, kElementArrayBuffer = 34963;  // target
constexpr int kRepeat = 10497;                                    // wrapS, wrapT

// The .bin file and what the JSON says of its pieces.
class Buffer {
 public:
  template <typename Vector>
  int addVectors(const std::vector<Vector>& vectors, const char* type) {
    std::vector<float> numbers;
    for (const Vector& v : vectors)
      for (int k = 0; k < Vector::length(); ++k) numbers.push_back(static_cast<float>(v[k]));
    return addAccessor(numbers.data(), numbers.size() * sizeof(float), kArrayBuffer,
                       {{"componentType", kFloat}, {"count", vectors.size()}, {"type", type}});
  }

  int addPositions(const std::vector<dvec3>& positions) {
    glm::vec3 low(INFINITY), high(-INFINITY);
    for (const dvec3& position : positions) {
      low = glm::min(low, glm::vec3(position));
      high = glm::max(high, glm::vec3(position));
    }
    const int accessor = addVectors(positions, "VEC3");
    accessors_[accessor]["min"] = {low.x, low.y, low.z};
    accessors_[accessor]["max"] = {high.x, high.y, high.z};
    return accessor;
  }

  int addTriangles(const std::vector<uvec3>& triangles) {
    return addAccessor(
        triangles.data(), triangles.size() * sizeof(uvec3), kElementArrayBuffer,
        {{"componentType", kUnsignedInt}, {"count", 3 * triangles.size()}, {"type", "SCALAR"}});
  }

  const std::string& bytes() const { return bytes_; }
  const Json& views() const { return views_; }
  const Json& accessors() const { return accessors_; }

 private:
  int addAccessor(const void* data, std::size_t size, int target, Json accessor) {
    views_.push_back(
        {{"buffer", 0}, {"byteOffset", bytes_.size()}, {"byteLength", size}, {"target", target}});
    bytes_.append(static_cast<const char*>(data), size);
    accessor["bufferView"] = views_.size() - 1;
    accessors_.push_back(std::move(accessor));
    return static_cast<int>(accessors_.size()) - 1;
  }

  std::string bytes_;
  Json views_ = Json::array();
  Json accessors_ = Json::array();
};

Json primitiveOf(const Part& part, const GltfMaterials& materials, Buffer& buffer) {
  const ShadedMesh mesh = shaded(part.mesh, part.crease);
  Json attributes = {{"POSITION", buffer.addPositions(mesh.positions)},
                     {"NORMAL", buffer.addVectors(mesh.normals, "VEC3")}};
  if (!mesh.texture_coordinates.empty())
    attributes["TEXCOORD_0"] = buffer.addVectors(mesh.texture_coordinates, "VEC2");
  Json primitive = {{"attributes", attributes},
                    {"indices", buffer.addTriangles(mesh.triangles)},
                    {"material", materials.indexOf(part.material)}};
  const Json mappings = materials.mappings(part.material);
  if (!mappings.empty())
    primitive["extensions"]["KHR_materials_variants"] = {{"mappings", mappings}};
  return primitive;
}

void addPictures(const std::filesystem::path& folder, const std::string& name, const Model& model,
                 Json& json) {
  if (model.pictures.empty()) return;
  Json textures = Json::array(), images = Json::array();
  for (const Picture& picture : model.pictures) {
    const std::string file = name + "-" + picture.name + ".png";
    writeDisplayImage(folder / file, {picture.width, picture.height, picture.rgb});
    textures.push_back({{"sampler", 0}, {"source", images.size()}});
    images.push_back({{"uri", file}});
  }
  json["samplers"] = Json::array({{{"wrapS", kRepeat}, {"wrapT", kRepeat}}});
  json["textures"] = textures;
  json["images"] = images;
}

void addExtensions(const GltfMaterials& materials, Json& json) {
  Json used = extensionsOf(materials.list());
  const Json variants = materials.variantNames();
  if (!variants.empty()) {
    used.push_back("KHR_materials_variants");
    json["extensions"]["KHR_materials_variants"] = {{"variants", variants}};
  }
  if (!used.empty()) json["extensionsUsed"] = used;
}

}  // namespace

void writeGltf(const std::filesystem::path& folder, const std::string& name, const Model& model) {
  const GltfMaterials materials(model);
  Buffer buffer;
  Json roots = Json::array(), nodes = Json::array(), meshes = Json::array();
  for (const Part& part : model.parts) {
    roots.push_back(nodes.size());
    nodes.push_back({{"name", part.name}, {"mesh", meshes.size()}});
    meshes.push_back(
        {{"name", part.name}, {"primitives", Json::array({primitiveOf(part, materials, buffer)})}});
  }
  Json json = {{"asset", {{"version", "2.0"}, {"generator", "glimt assets"}}},
               {"scene", 0},
               {"scenes", Json::array({{{"nodes", roots}}})},
               {"nodes", nodes},
               {"meshes", meshes}};
  json["materials"] = materials.list();
  addPictures(folder, name, model, json);
  addExtensions(materials, json);
  json["accessors"] = buffer.accessors();
  json["bufferViews"] = buffer.views();
  json["buffers"] = Json::array({{{"uri", name + ".bin"}, {"byteLength", buffer.bytes().size()}}});
  writeFile(folder / (name + ".bin"), buffer.bytes());
  writeFile(folder / (name + ".gltf"), json.dump(1) + "\n");
}

}  // namespace glimt::assets
