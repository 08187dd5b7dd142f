#include "renderer/scene/framing.h"

#include <algorithm>
#include <cmath>

namespace glimt {
namespace {

// Room around the model, as a part of it.
constexpr float kMargin = 1.05f;

// How far in front of the box a camera stands that just sees its front side.
float distanceToFill(const Vec3& size, float vertical_fov, float aspect) {
  const float half_height = std::tan(glm::radians(0.5f * vertical_fov));
  return 0.5f * kMargin * std::max(size.y, size.x / aspect) / half_height;
}

}  // namespace

Bounds boundsOf(const Scene& scene) {
  Bounds bounds;
  for (const Vec3& position : scene.positions) bounds.include(position);
  return bounds;
}

Camera framed(const Bounds& bounds, float aspect, const CameraSettings& settings) {
  Camera camera;
  camera.vertical_fov = settings.vertical_fov.value_or(camera.vertical_fov);
  if (!bounds.empty()) {
    const Vec3 size = bounds.size();
    camera.target = bounds.center();
    camera.position = camera.target;
    camera.position.z = bounds.max.z + distanceToFill(size, camera.vertical_fov, aspect);
  }
  if (settings.target) {
    const Vec3 target(*settings.target);
    camera.position += target - camera.target;
    camera.target = target;
  }
  if (settings.position) camera.position = Vec3(*settings.position);
  camera.up = settings.up.value_or(camera.up);
  camera.up = usableUp(camera);
  camera.orthographic_height = settings.orthographic_height.value_or(0.0f);
  camera.aperture_radius = settings.aperture_radius.value_or(0.0f);
  camera.aperture_blades = settings.aperture_blades.value_or(0);
  camera.focus_distance =
      settings.focus_distance.value_or(glm::distance(camera.position, camera.target));
  return camera;
}

Vec3 usableUp(const Camera& camera) {
  const glm::dvec3 view = glm::normalize(glm::dvec3(camera.target) - glm::dvec3(camera.position));
  const glm::dvec3 up = glm::normalize(glm::dvec3(camera.up));
  if (glm::length(glm::cross(view, up)) > 1e-4) return camera.up;
  if (std::abs(view.y) < 0.9) return {0, 1, 0};
  return {0, 0, view.y < 0 ? -1 : 1};
}

}  // namespace glimt
