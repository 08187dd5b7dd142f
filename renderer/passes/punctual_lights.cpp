#include "renderer/passes/punctual_lights.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "renderer/passes/alias_table.h"
#include "renderer/scene/framing.h"

namespace glimt {
namespace {

constexpr double kPi = std::numbers::pi;

// Of the samples, that is dealt out evenly among the lights.
constexpr double kEvenShare = 0.2;

double sceneRadius(const Scene& scene) {
  const Bounds bounds = boundsOf(scene);
  return bounds.empty() ? 1 : 0.5 * glm::length(glm::dvec3(bounds.size()));
}

double powerOf(const PunctualLight& light, double radius) {
  const glm::dvec3 intensity(light.intensity);
  const double mean = (intensity.r + intensity.g + intensity.b) / 3;
  switch (light.kind) {
    case PunctualLight::Kind::directional:
      return mean * kPi * radius * radius;
    case PunctualLight::Kind::spot:
      // The light between the cones is about that of one in the middle.
      return mean * 2 * kPi * (1 - std::cos(0.5 * (light.inner_cone + light.outer_cone)));
    case PunctualLight::Kind::point:
      break;
  }
  return mean * 4 * kPi;
}

std::vector<double> powersOf(const Scene& scene) {
  const double radius = sceneRadius(scene);
  std::vector<double> powers;
  for (const PunctualLight& light : scene.lights) powers.push_back(powerOf(light, radius));
  return powers;
}

// What a spot's cosine is multiplied by, and what is added: KHR_lights_punctual.
Vec2 coneOf(const PunctualLight& light) {
  if (light.kind != PunctualLight::Kind::spot) return {0, 1};
  const double inner = std::cos(static_cast<double>(light.inner_cone));
  const double outer = std::cos(static_cast<double>(light.outer_cone));
  const double scale = 1 / std::max(0.001, inner - outer);
  return Vec2(glm::dvec2(scale, -outer * scale));
}

void append(std::vector<Vec4>& texels, const PunctualLight& light, double probability,
            const Vec2& alias) {
  const bool far = light.kind == PunctualLight::Kind::directional;
  texels.emplace_back(far ? -light.direction : light.position, far ? 0.0f : 1.0f);
  texels.emplace_back(light.intensity, static_cast<float>(probability));
  texels.emplace_back(light.direction, light.range > 0 ? 1 / (light.range * light.range) : 0.0f);
  texels.emplace_back(coneOf(light), alias);
}

}  // namespace

double powerOfPunctualLights(const Scene& scene) {
  double sum = 0;
  for (const double power : powersOf(scene)) sum += power;
  return sum;
}

std::vector<Vec4> packPunctualLights(const Scene& scene) {
  const std::vector<double> powers = powersOf(scene);
  std::vector<PunctualLight> lights;
  std::vector<double> shares;
  double total = 0;
  for (std::size_t i = 0; i < powers.size(); ++i) {
    if (!(powers[i] > 0)) continue;
    lights.push_back(scene.lights[i]);
    shares.push_back(powers[i]);
    total += powers[i];
  }
  for (double& share : shares)
    share = (1 - kEvenShare) * share / total + kEvenShare / static_cast<double>(shares.size());
  std::vector<Vec4> texels;
  if (lights.empty()) return texels;
  const std::vector<AliasEntry> aliases = buildAliasTable(shares);
  for (std::size_t i = 0; i < lights.size(); ++i)
    append(texels, lights[i], shares[i],
           Vec2(aliases[i].share, static_cast<float>(aliases[i].other)));
  return texels;
}

}  // namespace glimt
