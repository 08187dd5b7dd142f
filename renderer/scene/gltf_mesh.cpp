#include "renderer/scene/gltf_mesh.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "renderer/core/wording.h"
#include "renderer/scene/gltf_accessor.h"
#include "renderer/scene/gltf_primitive.h"
#include "renderer/scene/gltf_variants.h"
#include "renderer/scene/scene_origin.h"

namespace glimt {
namespace {

constexpr std::size_t kMostTriangles = 1 << 23;

// What turns normals with the surface, whatever the matrix does to lengths and angles: the inverse
// transpose, times a positive number, so that it exists where the matrix is flat.
glm::dmat3 normalMatrixOf(const glm::dmat4& to_world) {
  const glm::dmat3 m(to_world);
  const glm::dmat3 cofactors(glm::cross(m[1], m[2]), glm::cross(m[2], m[0]),
                             glm::cross(m[0], m[1]));
  return glm::determinant(m) < 0 ? -cofactors : cofactors;
}

Vec2 finite(const Vec4& v, bool& changed) {
  if (std::isfinite(v.x) && std::isfinite(v.y)) return {v.x, v.y};
  changed = true;
  return Vec2(0);
}

// A NaN becomes 0.
Vec4 inUnitCube(Vec4 color) {
  for (int c = 0; c < 4; ++c) color[c] = color[c] >= 0 ? std::min(color[c], 1.0f) : 0;
  return color;
}

class MeshWriter {
 public:
  MeshWriter(const GltfDocument& document, Scene& scene) : document_(document), scene_(scene) {}

  // Of the primitive, which is written `copies` times.
  void demandRoom(const GltfGeometry& geometry, std::size_t copies, const std::string& who) const {
    const auto demand = [&](std::size_t there, std::size_t more, std::size_t most,
                            const char* what) {
      if (more > 0 && copies > (most - there) / more)
        document_.fail(
            fmt::format("with {}, of which there are {}, more than {} {}; use a coarser "
                        "model",
                        who, grouped(copies), grouped(most), what));
    };
    demand(positions_.size(), geometry.positions.size(), kMostGltfVertices, "vertices");
    demand(scene_.triangles.size(), geometry.triangles.size(), kMostTriangles, "triangles");
  }

  void write(const GltfGeometry& geometry, const glm::dmat4& to_world, std::uint32_t material) {
    const First first = {sizeOf(positions_), sizeOf(scene_.normals), sizeOf(scene_.texcoords),
                         sizeOf(scene_.colors)};
    writeVertices(geometry, to_world);
    const bool has_texcoords = !geometry.texcoords[0].empty() || !geometry.texcoords[1].empty();
    const bool mirrored = glm::determinant(glm::dmat3(to_world)) < 0;
    for (std::array<std::uint32_t, 3> corners : geometry.triangles) {
      // The front side stays the front side.
      if (mirrored) std::swap(corners[1], corners[2]);
      Triangle triangle;
      triangle.material = material;
      for (std::size_t k = 0; k < 3; ++k) {
        triangle.positions[k] = first.position + corners[k];
        if (!geometry.normals.empty()) triangle.normals[k] = first.normal + corners[k];
        if (has_texcoords) triangle.texcoords[k] = first.texcoord + corners[k];
        if (!geometry.colors.empty()) triangle.colors[k] = first.color + corners[k];
      }
      scene_.triangles.push_back(triangle);
    }
  }

  // Once all is written.
  void finish() {
    glm::dvec3 low(HUGE_VAL);
    glm::dvec3 high(-HUGE_VAL);
    for (const glm::dvec3& position : positions_) {
      if (!std::isfinite(position.x + position.y + position.z)) continue;
      low = glm::min(low, position);
      high = glm::max(high, position);
    }
    if (low.x <= high.x) scene_.origin = sceneOriginOf(low, high);
    scene_.positions.reserve(positions_.size());
    for (const glm::dvec3& position : positions_)
      scene_.positions.emplace_back(position - scene_.origin);
    if (texcoords_changed_)
      scene_.warnings.push_back("texture coordinates that are not finite numbers are taken for 0");
  }

 private:
  struct First {
    std::uint32_t position;
    std::uint32_t normal;
    std::uint32_t texcoord;
    std::uint32_t color;
  };

  template <typename T>
  static std::uint32_t sizeOf(const std::vector<T>& values) {
    return static_cast<std::uint32_t>(values.size());
  }

  void writeVertices(const GltfGeometry& geometry, const glm::dmat4& to_world) {
    for (const Vec4& position : geometry.positions)
      positions_.emplace_back(to_world * glm::dvec4(position));
    const glm::dmat3 turn = normalMatrixOf(to_world);
    for (const Vec4& normal : geometry.normals) {
      const glm::dvec3 turned = turn * glm::dvec3(normal);
      const double length = glm::length(turned);
      scene_.normals.emplace_back(length > 0 ? turned / length : glm::dvec3(0));
    }
    const std::size_t texcoords =
        std::max(geometry.texcoords[0].size(), geometry.texcoords[1].size());
    for (std::size_t i = 0; i < texcoords; ++i) {
      TexCoords& both = scene_.texcoords.emplace_back();
      for (std::size_t set = 0; set < 2; ++set)
        if (!geometry.texcoords[set].empty())
          both.sets[set] = finite(geometry.texcoords[set][i], texcoords_changed_);
    }
    for (const Vec4& color : geometry.colors) scene_.colors.push_back(inUnitCube(color));
  }

  const GltfDocument& document_;
  Scene& scene_;
  std::vector<glm::dvec3> positions_;  // in the file's coordinates
  bool texcoords_changed_ = false;
};

// In what a file can ask for beside its triangles.
struct LeftOut {
  std::size_t points_and_lines = 0;
  std::size_t without_positions = 0;
  bool morphed = false;
};

bool isMorphed(const tinygltf::Mesh& mesh) {
  return std::any_of(mesh.weights.begin(), mesh.weights.end(),
                     [](double weight) { return weight != 0; });
}

std::uint32_t demandMaterial(const GltfDocument& document, int material, const std::string& who) {
  const std::size_t count = document.model.materials.size();
  if (material == -1) return static_cast<std::uint32_t>(count);
  if (material < 0 || static_cast<std::size_t>(material) >= count)
    document.fail(fmt::format("{} uses material {}, but the file has {}; export the model again",
                              who, material, count));
  return static_cast<std::uint32_t>(material);
}

void warn(const LeftOut& left_out, bool skinned, Scene& scene) {
  const auto warn_if = [&](bool told, std::string what) {
    if (told) scene.warnings.push_back(std::move(what));
  };
  warn_if(left_out.points_and_lines > 0,
          fmt::format("dropped {} of points or lines: they have no surface",
                      counted(left_out.points_and_lines, "primitive")));
  warn_if(left_out.without_positions > 0,
          fmt::format("dropped {} without positions",
                      counted(left_out.without_positions, "primitive")));
  warn_if(left_out.morphed, "morph targets are ignored: meshes have their undeformed shape");
  warn_if(skinned, "skins are ignored: meshes stand as they are without");
}

bool isSkinned(const GltfDocument& document, const std::vector<GltfInstance>& instances) {
  return std::any_of(instances.begin(), instances.end(), [&](const GltfInstance& instance) {
    return document.model.nodes[instance.node].skin >= 0;
  });
}

}  // namespace

void readGltfMeshes(const GltfDocument& document, const std::vector<GltfInstance>& instances,
                    std::optional<std::size_t> variant, Scene& scene) {
  const auto& meshes = document.model.meshes;
  // So that each mesh is read once, and is there only while it is written.
  std::vector<std::vector<const GltfInstance*>> instances_of(meshes.size());
  for (const GltfInstance& instance : instances) instances_of[instance.index].push_back(&instance);
  MeshWriter writer(document, scene);
  LeftOut left_out;
  for (std::size_t m = 0; m < meshes.size(); ++m) {
    if (instances_of[m].empty()) continue;
    left_out.morphed = left_out.morphed || isMorphed(meshes[m]);
    for (std::size_t p = 0; p < meshes[m].primitives.size(); ++p) {
      const tinygltf::Primitive& primitive = meshes[m].primitives[p];
      const std::string who = fmt::format("primitive {} of mesh {}", p, m);
      if (!hasTriangles(primitive)) {
        const bool has_positions = primitive.attributes.contains("POSITION");
        ++(has_positions ? left_out.points_and_lines : left_out.without_positions);
        continue;
      }
      const std::uint32_t material = demandMaterial(document, materialOf(primitive, variant), who);
      const GltfGeometry geometry = readGltfPrimitive(document, primitive, who);
      writer.demandRoom(geometry, instances_of[m].size(), who);
      for (const GltfInstance* instance : instances_of[m])
        writer.write(geometry, instance->to_world, material);
    }
  }
  writer.finish();
  warn(left_out, isSkinned(document, instances), scene);
}

}  // namespace glimt
