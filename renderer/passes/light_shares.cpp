#include "renderer/passes/light_shares.h"

#include <algorithm>
#include <numbers>

#include "renderer/passes/punctual_lights.h"

namespace glimt {
namespace {

constexpr double kPi = std::numbers::pi;

double meanOf(const Vec3& color) {
  return (static_cast<double>(color.r) + color.g + color.b) / 3;
}

double powerOfTriangles(const Scene& scene, const LightTable& lights) {
  double power = 0;
  for (const Triangle& triangle : scene.triangles)
    if (lights.densities[triangle.material] > 0)
      power += areaOf(scene, triangle) * emissionWeight(scene, scene.materials[triangle.material]);
  return kPi * power;
}

double areaOfAll(const Scene& scene) {
  double area = 0;
  for (const Triangle& triangle : scene.triangles) area += areaOf(scene, triangle);
  return area;
}

// Rays that surfaces send out by chance find an even environment as well as its light samples do:
// those only add to the rays' number, while lights nearby depend on theirs. With irradiances E of
// the environment and e of the lights, the variance is about v E^2 / (1 + share) + e^2 / (1 -
// share); it is least where (1 + share) / (1 - share) = sqrt(v) E / e.
double evenEnvironmentShare(double environment_irradiance, double nearby_irradiance) {
  constexpr double kDeviation = 0.25;  // sqrt(v), fitted to scenes in the open and in rooms
  constexpr double kLeast = 1.0 / 16;  // a path's last surface sends no ray
  constexpr double kMost = 0.5;
  const double environment = kDeviation * environment_irradiance;
  return std::clamp((environment - nearby_irradiance) / (environment + nearby_irradiance), kLeast,
                    kMost);
}

double environmentShare(const Scene& scene, double nearby_power) {
  if (!scene.environment.shines()) return 0;
  if (!(nearby_power > 0)) return 1;
  if (!scene.environment.image.pixels.empty()) return 0.5;
  return evenEnvironmentShare(kPi * meanOf(scene.environment.radiance()),
                              nearby_power / std::max(areaOfAll(scene), 1e-30));
}

}  // namespace

Vec3 lightShares(const Scene& scene, const LightTable& triangles) {
  constexpr double kLeast = 0.25;
  const double punctual_power = powerOfPunctualLights(scene);
  const double triangle_power = powerOfTriangles(scene, triangles);
  const double nearby_power = triangle_power + punctual_power;
  if (!(nearby_power > 0)) return Vec3(scene.environment.shines() ? 1 : 0, 0, 0);
  double of_triangles = triangle_power / nearby_power;
  if (triangle_power > 0 && punctual_power > 0)
    of_triangles = std::clamp(of_triangles, kLeast, 1 - kLeast);
  const double outside = environmentShare(scene, nearby_power);
  return Vec3(outside, (1 - outside) * of_triangles, (1 - outside) * (1 - of_triangles));
}

}  // namespace glimt
