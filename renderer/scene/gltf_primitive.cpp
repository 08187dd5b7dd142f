#include "renderer/scene/gltf_primitive.h"

#include <fmt/format.h>

#include <algorithm>

#include "renderer/scene/gltf_accessor.h"
#include "renderer/scene/gltf_draco.h"

namespace glimt {
namespace {

using Corners = std::array<std::uint32_t, 3>;

// Reads the attributes of a primitive that is not packed.
class AttributeReader {
 public:
  AttributeReader(const GltfDocument& document, const tinygltf::Primitive& primitive,
                  const std::string& who)
      : document_(document), primitive_(primitive), who_(who) {}

  std::vector<Vec4> read(const char* name, int fewest, int most) const {
    const auto found = primitive_.attributes.find(name);
    if (found == primitive_.attributes.end()) return {};
    return readGltfVectors(document_, found->second, fewest, most,
                           fmt::format("{} of {}", name, who_));
  }

 private:
  const GltfDocument& document_;
  const tinygltf::Primitive& primitive_;
  const std::string& who_;
};

std::vector<std::uint32_t> cornersOf(const GltfDocument& document,
                                     const tinygltf::Primitive& primitive, std::size_t vertices,
                                     const std::string& who) {
  if (primitive.indices >= 0)
    return readGltfIndices(document, primitive.indices, "indices of " + who);
  std::vector<std::uint32_t> corners(vertices);
  for (std::size_t i = 0; i < vertices; ++i) corners[i] = static_cast<std::uint32_t>(i);
  return corners;
}

// Each with the winding that the specification gives it.
std::vector<Corners> trianglesOf(const std::vector<std::uint32_t>& corners, int mode) {
  std::vector<Corners> triangles;
  if (mode == TINYGLTF_MODE_TRIANGLES) {
    triangles.reserve(corners.size() / 3);
    for (std::size_t i = 0; i + 2 < corners.size(); i += 3)
      triangles.push_back({corners[i], corners[i + 1], corners[i + 2]});
    return triangles;
  }
  for (std::size_t i = 0; i + 2 < corners.size(); ++i) {
    if (mode == TINYGLTF_MODE_TRIANGLE_FAN)
      triangles.push_back({corners[i + 1], corners[i + 2], corners[0]});
    else
      triangles.push_back({corners[i], corners[i + 1 + i % 2], corners[i + 2 - i % 2]});
  }
  return triangles;
}

void demandEqualCounts(const GltfDocument& document, const GltfGeometry& geometry,
                       const std::string& who) {
  const std::size_t count = geometry.positions.size();
  for (const auto* attribute :
       {&geometry.normals, &geometry.texcoords[0], &geometry.texcoords[1], &geometry.colors}) {
    if (!attribute->empty() && attribute->size() != count)
      document.fail(
          fmt::format("{} has {} positions, but {} of another attribute; export the "
                      "model again",
                      who, count, attribute->size()));
  }
}

void demandInRange(const GltfDocument& document, const std::vector<std::uint32_t>& corners,
                   std::size_t vertices, const std::string& who) {
  if (corners.empty()) return;
  const std::uint32_t largest = *std::max_element(corners.begin(), corners.end());
  if (largest >= vertices)
    document.fail(fmt::format("{} uses vertex {}, but has {}; export the model again", who, largest,
                              vertices));
}

}  // namespace

bool hasTriangles(const tinygltf::Primitive& primitive) {
  return primitive.attributes.contains("POSITION") && primitive.mode >= TINYGLTF_MODE_TRIANGLES &&
         primitive.mode <= TINYGLTF_MODE_TRIANGLE_FAN;
}

GltfGeometry readGltfPrimitive(const GltfDocument& document, const tinygltf::Primitive& primitive,
                               const std::string& who) {
  GltfGeometry geometry;
  if (isDraco(primitive)) {
    geometry = readDracoPrimitive(document, primitive, who);
  } else {
    const AttributeReader attributes(document, primitive, who);
    geometry.positions = attributes.read("POSITION", 3, 3);
    geometry.normals = attributes.read("NORMAL", 3, 3);
    geometry.texcoords = {attributes.read("TEXCOORD_0", 2, 2), attributes.read("TEXCOORD_1", 2, 2)};
    geometry.colors = attributes.read("COLOR_0", 3, 4);
    const std::vector<std::uint32_t> corners =
        cornersOf(document, primitive, geometry.positions.size(), who);
    demandInRange(document, corners, geometry.positions.size(), who);
    geometry.triangles = trianglesOf(corners, primitive.mode);
  }
  demandEqualCounts(document, geometry, who);
  return geometry;
}

}  // namespace glimt
