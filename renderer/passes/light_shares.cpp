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

double areaOfAll(const Scene& scene) {
  double area = 0;
  for (const Triangle& triangle : scene.triangles) area += areaOf(scene, triangle);
  return area;
}

// What surfaces would get from all sides if nothing were between, in the mean.
struct Irradiances {
  double environment = 0;
  double nearby = 0;
};

// Rays that surfaces send out by chance find an even environment as well as its light samples do:
// those only add to the rays' number, while lights nearby depend on theirs. With irradiances E of
// the environment and e of the lights, the variance is about v E^2 / (1 + share) + e^2 / (1 -
// share); it is least where (1 + share) / (1 - share) = sqrt(v) E / e.
double usualShare(const Irradiances& irradiances) {
  constexpr double kDeviation = 0.25;  // sqrt(v), fitted to scenes in the open and in rooms
  const double environment = kDeviation * irradiances.environment;
  const double nearby = irradiances.nearby;
  return std::clamp((environment - nearby) / (environment + nearby), 1.0 / 16, 0.5);
}

// Without such rays the variance is about E^2 / share + e^2 / (1 - share).
double shareAlone(const Irradiances& irradiances) {
  const double all = irradiances.environment + irradiances.nearby;
  return std::clamp(irradiances.environment / all, 0.25, 0.75);
}

Vec3 sharesOf(double environment, double of_triangles) {
  return Vec3(environment, (1 - environment) * of_triangles,
              (1 - environment) * (1 - of_triangles));
}

double triangleShare(double triangle_power, double punctual_power) {
  constexpr double kLeast = 0.25;
  const double share = triangle_power / (triangle_power + punctual_power);
  const bool both = triangle_power > 0 && punctual_power > 0;
  return both ? std::clamp(share, kLeast, 1 - kLeast) : share;
}

}  // namespace

LightShares lightShares(const Scene& scene, const LightTable& triangles) {
  const Environment& environment = scene.environment;
  const double outside = environment.shines() ? 1 : 0;
  const double punctual_power = powerOfPunctualLights(scene);
  const double power = triangles.power + punctual_power;
  if (!(power > 0)) return {Vec3(outside, 0, 0), Vec3(outside, 0, 0)};
  const double of_triangles = triangleShare(triangles.power, punctual_power);
  if (outside == 0 || !environment.image.pixels.empty()) {
    const Vec3 shares = sharesOf(0.5 * outside, of_triangles);
    return {shares, shares};
  }
  const Irradiances irradiances{kPi * meanOf(environment.radiance()),
                                power / std::max(areaOfAll(scene), 1e-30)};
  return {sharesOf(usualShare(irradiances), of_triangles),
          sharesOf(shareAlone(irradiances), of_triangles)};
}

}  // namespace glimt
