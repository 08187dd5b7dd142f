#include "renderer/passes/light_shares.h"

#include <algorithm>
#include <numbers>

#include "renderer/passes/punctual_lights.h"

namespace glimt {
namespace {

double powerOfTriangles(const Scene& scene, const LightTable& lights) {
  double power = 0;
  for (const Triangle& triangle : scene.triangles)
    if (lights.densities[triangle.material] > 0)
      power += areaOf(scene, triangle) * emissionWeight(scene, scene.materials[triangle.material]);
  return std::numbers::pi * power;
}

}  // namespace

Vec3 lightShares(const Scene& scene, const LightTable& triangles) {
  constexpr double kLeast = 0.25;
  const double punctual_power = powerOfPunctualLights(scene);
  const bool has_triangles = !triangles.entries.empty();
  const bool has_punctual = punctual_power > 0;
  double of_triangles = has_triangles ? 1 : 0;
  if (has_triangles && has_punctual) {
    const double power = powerOfTriangles(scene, triangles);
    of_triangles = std::clamp(power / (power + punctual_power), kLeast, 1 - kLeast);
  }
  double nearby = has_triangles || has_punctual ? 1 : 0;
  const double outside = scene.environment.shines() ? 1 - 0.5 * nearby : 0;
  nearby *= 1 - outside;
  return Vec3(outside, nearby * of_triangles, nearby * (1 - of_triangles));
}

}  // namespace glimt
