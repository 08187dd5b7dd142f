#include "renderer/scene/effects_of.h"

#include <fmt/format.h>

#include <algorithm>

#include "renderer/core/wording.h"

namespace glimt {
namespace {

bool anyPositive(const Vec3& v) {
  return v.x > 0 || v.y > 0 || v.z > 0;
}

EffectReport reportTriangleLights(const Scene& scene) {
  const auto count = std::count_if(
      scene.triangles.begin(), scene.triangles.end(), [&scene](const Triangle& triangle) {
        return anyPositive(scene.materials[triangle.material].emission);
      });
  const std::string reason =
      count == 0 ? "no triangle emits"
                 : fmt::format("{} emit{}", counted(static_cast<std::size_t>(count), "triangle"),
                               count == 1 ? "s" : "");
  return {Effect::triangle_lights, "triangle_lights", count > 0, reason};
}

EffectReport reportEnvironment(const Scene& scene) {
  const Vec3 radiance = scene.environment.radiance();
  const bool on = anyPositive(radiance);
  const std::string reason = on ? fmt::format("environment radiance is ({:g}, {:g}, {:g})",
                                              radiance.x, radiance.y, radiance.z)
                                : "its radiance is zero";
  return {Effect::environment, "environment", on, reason};
}

EffectReport reportSmoothNormals(const Scene& scene) {
  const auto count = std::count_if(scene.triangles.begin(), scene.triangles.end(),
                                   [](const Triangle& triangle) { return triangle.smooth(); });
  const std::string reason =
      count == 0 ? "no triangle has normals"
                 : fmt::format("{} of {} {} normals", grouped(static_cast<std::size_t>(count)),
                               counted(scene.triangles.size(), "triangle"),
                               scene.triangles.size() == 1 ? "has" : "have");
  return {Effect::smooth_normals, "smooth_normals", count > 0, reason};
}

}  // namespace

std::vector<EffectReport> reportEffects(const Scene& scene) {
  return {reportTriangleLights(scene), reportEnvironment(scene), reportSmoothNormals(scene)};
}

EffectSet effectsOf(const Scene& scene) {
  EffectSet effects;
  for (const EffectReport& report : reportEffects(scene)) {
    effects[static_cast<std::size_t>(report.effect)] = report.on;
  }
  return effects;
}

}  // namespace glimt
