#include "renderer/scene/gltf_light.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "renderer/core/wording.h"
#include "renderer/scene/scene_check.h"

namespace glimt {
namespace {

constexpr float kRightAngle = 1.57079633f;

PunctualLight::Kind kindOf(const GltfDocument& document, const tinygltf::Light& light) {
  if (light.type == "point") return PunctualLight::Kind::point;
  if (light.type == "spot") return PunctualLight::Kind::spot;
  if (light.type == "directional") return PunctualLight::Kind::directional;
  document.fail(fmt::format("a light of type '{}'; there are point, spot and directional",
                            printable(light.type)));
}

bool isUsable(const PunctualLight& light) {
  const Vec3 size = glm::abs(light.position);
  const float sum = light.intensity.x + light.intensity.y + light.intensity.z;
  return std::max({size.x, size.y, size.z}) <= kLargestCoordinate && std::isfinite(sum) &&
         std::min({light.intensity.x, light.intensity.y, light.intensity.z}) >= 0 &&
         std::abs(glm::length(light.direction) - 1) < 1e-3f && std::isfinite(light.range);
}

PunctualLight lightOf(const GltfDocument& document, const GltfInstance& instance,
                      const glm::dvec3& origin) {
  const tinygltf::Light& given = document.model.lights[instance.index];
  PunctualLight light;
  light.name = document.model.nodes[instance.node].name;
  if (light.name.empty()) light.name = given.name;
  light.kind = kindOf(document, given);
  light.position = Vec3(glm::dvec3(instance.to_world[3]) - origin);
  // Scales turn nothing and dim nothing.
  light.direction = Vec3(-glm::normalize(glm::dvec3(instance.to_world[2])));
  Vec3 color(1);
  if (given.color.size() >= 3) color = Vec3(given.color[0], given.color[1], given.color[2]);
  light.intensity = color * static_cast<float>(given.intensity);
  light.range = std::max(static_cast<float>(given.range), 0.0f);
  if (light.kind == PunctualLight::Kind::spot) {
    light.outer_cone =
        std::clamp(static_cast<float>(given.spot.outerConeAngle), 1e-3f, kRightAngle);
    light.inner_cone =
        std::clamp(static_cast<float>(given.spot.innerConeAngle), 0.0f, light.outer_cone);
  }
  return light;
}

}  // namespace

std::vector<PunctualLight> lightsOf(const GltfDocument& document,
                                    const std::vector<GltfInstance>& instances,
                                    const glm::dvec3& origin, std::vector<std::string>& warnings) {
  std::vector<PunctualLight> lights;
  std::vector<std::string> unusable;
  for (const GltfInstance& instance : instances) {
    PunctualLight light = lightOf(document, instance, origin);
    if (isUsable(light))
      lights.push_back(std::move(light));
    else
      unusable.push_back(printable(light.name));
  }
  if (!unusable.empty())
    warnings.push_back(fmt::format("lights that cannot shine are left out: {}", listed(unusable)));
  return lights;
}

}  // namespace glimt
