#include "renderer/scene/light_check.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "renderer/core/wording.h"
#include "renderer/scene/scene_check.h"

namespace glimt {
namespace {

bool isFinite(const Vec3& v) {
  return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

bool isSound(PunctualLight& light) {
  if (!isFinite(light.position) || !isFinite(light.direction) || !isFinite(light.intensity))
    return false;
  const Vec3 size = glm::abs(light.position);
  if (std::max({size.x, size.y, size.z}) > kLargestCoordinate) return false;
  if (std::min({light.intensity.r, light.intensity.g, light.intensity.b}) < 0) return false;
  const glm::dvec3 direction(light.direction);
  const double length = glm::length(direction);
  if (!(length > 0)) return light.kind == PunctualLight::Kind::point;
  light.direction = Vec3(direction / length);
  return true;
}

void limitNumbers(PunctualLight& light) {
  constexpr float kRightAngle = std::numbers::pi_v<float> / 2;
  if (!(light.range >= 0) || !std::isfinite(light.range)) light.range = 0;
  if (!(light.outer_cone >= 0)) light.outer_cone = 0;
  light.outer_cone = std::min(light.outer_cone, kRightAngle);
  if (!(light.inner_cone >= 0)) light.inner_cone = 0;
  light.inner_cone = std::min(light.inner_cone, light.outer_cone);
}

}  // namespace

void checkLights(Scene& scene) {
  const std::size_t before = scene.lights.size();
  std::erase_if(scene.lights, [](PunctualLight& light) { return !isSound(light); });
  for (PunctualLight& light : scene.lights) limitNumbers(light);
  if (const std::size_t dropped = before - scene.lights.size(); dropped > 0)
    scene.warnings.push_back(fmt::format(
        "dropped {} whose place, direction or intensity is not usable", counted(dropped, "light")));
}

}  // namespace glimt
