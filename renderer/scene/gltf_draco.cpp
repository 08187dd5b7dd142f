#include "renderer/scene/gltf_draco.h"

#include <draco/compression/decode.h>
#include <fmt/format.h>

#include "renderer/core/wording.h"
#include "renderer/scene/gltf_accessor.h"
#include "renderer/scene/gltf_extensions.h"

namespace glimt {
namespace {

constexpr const char* kDraco = "KHR_draco_mesh_compression";

std::unique_ptr<draco::Mesh> unpack(const GltfDocument& document, std::string_view bytes,
                                    const std::string& who) {
  draco::DecoderBuffer buffer;
  buffer.Init(bytes.data(), bytes.size());
  auto result = draco::Decoder().DecodeMeshFromBuffer(&buffer);
  if (!result.ok() || result.value() == nullptr)
    document.fail(fmt::format("{} cannot be unpacked by Draco ({}); export the model again", who,
                              printable(result.status().error_msg_string())));
  std::unique_ptr<draco::Mesh> mesh = std::move(result).value();
  if (mesh->num_points() > kMostGltfVertices || mesh->num_faces() > kMostGltfVertices)
    document.fail(
        fmt::format("{} unpacks to more than {} vertices or triangles; use a coarser "
                    "model",
                    who, grouped(kMostGltfVertices)));
  return mesh;
}

// Whether the accessor, whose numbers are in Draco's data, is of integers that mean shares of one.
bool isNormalized(const GltfDocument& document, const tinygltf::Primitive& primitive,
                  const std::string& name) {
  const auto found = primitive.attributes.find(name);
  if (found == primitive.attributes.end() || found->second < 0) return false;
  const auto index = static_cast<std::size_t>(found->second);
  return index < document.model.accessors.size() && document.model.accessors[index].normalized;
}

class DracoAttributes {
 public:
  DracoAttributes(const GltfDocument& document, const tinygltf::Primitive& primitive,
                  const tinygltf::Value& names, const draco::Mesh& mesh, const std::string& who)
      : document_(document), primitive_(primitive), names_(names), mesh_(mesh), who_(who) {}

  std::vector<Vec4> read(const char* name, int fewest, int most) const {
    const std::optional<int> id = indexOf(names_, name);
    if (!id) return {};
    const draco::PointAttribute* const attribute =
        *id < 0 ? nullptr : mesh_.GetAttributeByUniqueId(static_cast<std::uint32_t>(*id));
    if (attribute == nullptr || attribute->num_components() < fewest ||
        attribute->num_components() > most)
      document_.fail(
          fmt::format("{} of {} is not in its Draco data; export the model again", name, who_));
    std::vector<Vec4> values;
    values.reserve(mesh_.num_points());
    const float scale = isNormalized(document_, primitive_, name) && !attribute->normalized()
                            ? scaleOf(attribute->data_type())
                            : 1;
    for (draco::PointIndex i(0); i < mesh_.num_points(); ++i) {
      const draco::AttributeValueIndex index = attribute->mapped_index(i);
      Vec4 value(0, 0, 0, 1);
      if (index.value() >= attribute->size() ||
          !attribute->ConvertValue<float>(index, attribute->num_components(), &value[0]))
        document_.fail(
            fmt::format("{} of {} has values that are not in its Draco data; export "
                        "the model again",
                        name, who_));
      for (int c = 0; c < attribute->num_components(); ++c) value[c] *= scale;
      values.push_back(value);
    }
    return values;
  }

 private:
  static float scaleOf(draco::DataType type) {
    switch (type) {
      case draco::DT_INT8:
        return 1.0f / 127;
      case draco::DT_UINT8:
        return 1.0f / 255;
      case draco::DT_INT16:
        return 1.0f / 32767;
      case draco::DT_UINT16:
        return 1.0f / 65535;
      default:
        return 1;
    }
  }

  const GltfDocument& document_;
  const tinygltf::Primitive& primitive_;
  const tinygltf::Value& names_;
  const draco::Mesh& mesh_;
  const std::string& who_;
};

}  // namespace

bool isDraco(const tinygltf::Primitive& primitive) {
  return extensionOf(primitive.extensions, kDraco) != nullptr;
}

GltfGeometry readDracoPrimitive(const GltfDocument& document, const tinygltf::Primitive& primitive,
                                const std::string& who) {
  const tinygltf::Value& extension = *extensionOf(primitive.extensions, kDraco);
  const tinygltf::Value* const names = memberOf(extension, "attributes");
  if (names == nullptr)
    document.fail(
        fmt::format("{} does not say what its Draco data are; export the model again", who));
  const std::string_view bytes =
      document.bytesOf(indexOf(extension, "bufferView").value_or(-1), who);
  const std::unique_ptr<draco::Mesh> mesh = unpack(document, bytes, who);
  const DracoAttributes attributes(document, primitive, *names, *mesh, who);
  GltfGeometry geometry;
  geometry.positions = attributes.read("POSITION", 3, 3);
  geometry.normals = attributes.read("NORMAL", 3, 3);
  geometry.texcoords = {attributes.read("TEXCOORD_0", 2, 2), attributes.read("TEXCOORD_1", 2, 2)};
  geometry.colors = attributes.read("COLOR_0", 3, 4);
  for (draco::FaceIndex i(0); i < mesh->num_faces(); ++i) {
    const draco::Mesh::Face& face = mesh->face(i);
    std::array<std::uint32_t, 3> corners{};
    for (std::size_t k = 0; k < 3; ++k) {
      corners[k] = face[k].value();
      if (corners[k] >= geometry.positions.size())
        document.fail(fmt::format("{} uses vertex {}, but has {}; export the model again", who,
                                  corners[k], geometry.positions.size()));
    }
    geometry.triangles.push_back(corners);
  }
  return geometry;
}

}  // namespace glimt
