#include "renderer/scene/gltf_camera.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "renderer/core/wording.h"
#include "renderer/scene/framing.h"
#include "renderer/scene/scene_check.h"

namespace glimt {
namespace {

// How far in front of the camera its target is. Anything does for the picture.
double targetDistance(const glm::dvec3& position, const glm::dvec3& forward, const Bounds& bounds) {
  if (bounds.empty()) return 1;
  const double size = glm::length(glm::dvec3(bounds.size()));
  const double along = glm::dot(glm::dvec3(bounds.center()) - position, forward);
  return std::max({along, 0.01 * size, 1e-3 * glm::length(position), 1e-6});
}

bool setLens(const tinygltf::Camera& given, Camera& camera) {
  if (given.type == "orthographic") {
    camera.orthographic_height = static_cast<float>(2 * std::abs(given.orthographic.ymag));
    return camera.orthographic_height > 0 && std::isfinite(camera.orthographic_height);
  }
  // The picture's own aspect is that of the picture that is asked for.
  camera.vertical_fov = static_cast<float>(glm::degrees(given.perspective.yfov));
  return camera.vertical_fov > 0 && camera.vertical_fov < 180;
}

bool isPlace(const glm::dvec3& position) {
  const glm::dvec3 size = glm::abs(position);
  return std::max({size.x, size.y, size.z}) <= kLargestCoordinate;
}

std::optional<Camera> cameraOf(const tinygltf::Camera& given, const GltfInstance& instance,
                               const Bounds& bounds, const glm::dvec3& origin) {
  Camera camera;
  const glm::dmat3 turn(instance.to_world);
  const glm::dvec3 position = glm::dvec3(instance.to_world[3]) - origin;
  const glm::dvec3 forward = -glm::normalize(turn[2]);
  const glm::dvec3 up = glm::normalize(turn[1]);
  if (!setLens(given, camera) || !isPlace(position)) return {};
  // Also where an axis has no length.
  if (!(glm::length(glm::cross(forward, up)) > 1e-4)) return {};
  camera.position = Vec3(position);
  camera.target = Vec3(position + forward * targetDistance(position, forward, bounds));
  camera.up = Vec3(up);
  if (!isPlace(camera.target) || camera.target == camera.position) return {};
  return camera;
}

}  // namespace

std::vector<NamedCamera> camerasOf(const GltfDocument& document,
                                   const std::vector<GltfInstance>& instances, const Bounds& bounds,
                                   const glm::dvec3& origin, std::vector<std::string>& warnings) {
  std::vector<NamedCamera> cameras;
  std::vector<std::string> unusable;
  for (const GltfInstance& instance : instances) {
    const tinygltf::Camera& given = document.model.cameras[instance.index];
    std::string name = document.model.nodes[instance.node].name;
    if (name.empty()) name = given.name;
    if (name.empty()) name = fmt::format("camera {}", cameras.size());
    if (const std::optional<Camera> camera = cameraOf(given, instance, bounds, origin))
      cameras.push_back({name, *camera});
    else
      unusable.push_back(printable(name));
  }
  if (!unusable.empty())
    warnings.push_back(
        fmt::format("cameras that cannot be looked through are left out: {}", listed(unusable)));
  return cameras;
}

}  // namespace glimt
