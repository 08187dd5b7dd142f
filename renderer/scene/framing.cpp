#include "renderer/scene/framing.h"

#include <algorithm>
#include <cmath>

namespace glimt {
namespace {

// Room around the model, as a part of it.
constexpr float kMargin = 1.05f;

// A model lies flat that is less high than this part of its width or depth: seen from the front
// there would be nothing of it.
constexpr float kFlat = 0.05f;

// How far from a rectangle a camera stands that it just fills the picture of.
float distanceToFill(float width, float height, float vertical_fov, float aspect) {
  const float half_height = std::tan(glm::radians(0.5f * vertical_fov));
  return 0.5f * kMargin * std::max(height, width / aspect) / half_height;
}

// Where a camera looks at the centre from.
Vec3 viewpoint(const Bounds& bounds, float vertical_fov, float aspect) {
  const Vec3 size = bounds.size();
  if (size.y >= kFlat * std::max(size.x, size.z)) {
    Vec3 position = bounds.center();
    position.z = bounds.max.z + distanceToFill(size.x, size.y, vertical_fov, aspect);
    return position;
  }
  const float half = std::sqrt(0.5f);
  const float nearest = 0.5f * half * size.z;
  const float height = half * (size.z + size.y);
  return bounds.center() +
         (nearest + distanceToFill(size.x, height, vertical_fov, aspect)) * Vec3(0, half, half);
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
    camera.target = bounds.center();
    camera.position = viewpoint(bounds, camera.vertical_fov, aspect);
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
