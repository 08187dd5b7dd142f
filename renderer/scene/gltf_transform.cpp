#include "renderer/scene/gltf_transform.h"

#include <fmt/format.h>

#include <glm/gtc/matrix_transform.hpp>
#include <glm/gtc/quaternion.hpp>
#include <glm/gtc/type_ptr.hpp>

#include "renderer/core/wording.h"
#include "renderer/scene/gltf_accessor.h"
#include "renderer/scene/gltf_extensions.h"

namespace glimt {
namespace {

// Each instance has at least one triangle.
constexpr std::size_t kMostRepeats = 1 << 20;

// x, y, z, w as glTF orders them. One of no length turns nothing.
glm::dmat4 rotationOf(const glm::dvec4& q) {
  const double length = glm::length(q);
  if (!(length > 0)) return glm::dmat4(1);
  return glm::mat4_cast(glm::dquat(q.w / length, q.x / length, q.y / length, q.z / length));
}

glm::dmat4 combined(const glm::dvec3& translation, const glm::dvec4& rotation,
                    const glm::dvec3& scale) {
  return glm::translate(glm::dmat4(1), translation) * rotationOf(rotation) *
         glm::scale(glm::dmat4(1), scale);
}

void demandCount(const GltfDocument& document, const std::vector<double>& numbers,
                 std::size_t count, const char* what) {
  if (!numbers.empty() && numbers.size() != count)
    document.fail(fmt::format("a node's {} has {} numbers instead of {}; export the model again",
                              what, numbers.size(), count));
}

}  // namespace

glm::dmat4 transformOf(const GltfDocument& document, const tinygltf::Node& node) {
  demandCount(document, node.matrix, 16, "matrix");
  demandCount(document, node.translation, 3, "translation");
  demandCount(document, node.rotation, 4, "rotation");
  demandCount(document, node.scale, 3, "scale");
  if (!node.matrix.empty()) return glm::make_mat4(node.matrix.data());
  const auto& t = node.translation;
  const auto& r = node.rotation;
  const auto& s = node.scale;
  return combined(t.empty() ? glm::dvec3(0) : glm::dvec3(t[0], t[1], t[2]),
                  r.empty() ? glm::dvec4(0, 0, 0, 1) : glm::dvec4(r[0], r[1], r[2], r[3]),
                  s.empty() ? glm::dvec3(1) : glm::dvec3(s[0], s[1], s[2]));
}

std::vector<glm::dmat4> repeatsOf(const GltfDocument& document, const tinygltf::Node& node) {
  const tinygltf::Value* const extension = extensionOf(node.extensions, "EXT_mesh_gpu_instancing");
  const tinygltf::Value* const attributes =
      extension == nullptr ? nullptr : memberOf(*extension, "attributes");
  if (attributes == nullptr) return {};
  std::size_t count = 0;
  const auto read = [&](const char* name, int components) {
    const std::optional<int> accessor = indexOf(*attributes, name);
    if (!accessor) return std::vector<Vec4>();
    std::vector<Vec4> values = readGltfVectors(document, *accessor, components, components,
                                               fmt::format("{} of EXT_mesh_gpu_instancing", name));
    if (count != 0 && values.size() != count)
      document.fail(
          "EXT_mesh_gpu_instancing has attributes of different counts; export the model "
          "again");
    count = values.size();
    return values;
  };
  const std::vector<Vec4> translations = read("TRANSLATION", 3);
  const std::vector<Vec4> rotations = read("ROTATION", 4);
  const std::vector<Vec4> scales = read("SCALE", 3);
  if (count > kMostRepeats)
    document.fail(fmt::format("EXT_mesh_gpu_instancing has {} instances; at most {} are read",
                              grouped(count), grouped(kMostRepeats)));
  std::vector<glm::dmat4> repeats;
  for (std::size_t i = 0; i < count; ++i)
    repeats.push_back(
        combined(translations.empty() ? glm::dvec3(0) : glm::dvec3(translations[i]),
                 rotations.empty() ? glm::dvec4(0, 0, 0, 1) : glm::dvec4(rotations[i]),
                 scales.empty() ? glm::dvec3(1) : glm::dvec3(scales[i])));
  return repeats;
}

}  // namespace glimt
