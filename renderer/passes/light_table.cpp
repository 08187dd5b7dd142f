#include "renderer/passes/light_table.h"

#include <numbers>
#include <numeric>

#include "renderer/passes/alias_table.h"
#include "renderer/scene/texture_uses.h"

namespace glimt {
namespace {

// Of the samples, that is dealt out evenly among materials. It makes the noise of the brightest
// light larger by an eighth at the most.
constexpr double kEvenShare = 0.2;

// Of each material that emits, in square metres; 0 for the others.
std::vector<double> emittingAreas(const Scene& scene, const std::vector<double>& weights) {
  std::vector<double> areas(scene.materials.size());
  for (const Triangle& triangle : scene.triangles)
    if (weights[triangle.material] > 0) areas[triangle.material] += areaOf(scene, triangle);
  return areas;
}

// Of all materials, Lambert's pi left out.
double powerOf(const std::vector<double>& weights, const std::vector<double>& areas) {
  return std::inner_product(areas.begin(), areas.end(), weights.begin(), 0.0);
}

// Of samples on each material. Their integral over all areas is 1.
std::vector<double> densitiesOf(const std::vector<double>& weights,
                                const std::vector<double>& areas) {
  const double total_power = powerOf(weights, areas);
  double materials = 0;
  for (const double area : areas) materials += area > 0;
  std::vector<double> densities(areas.size());
  for (std::size_t i = 0; i < areas.size(); ++i)
    if (areas[i] > 0)
      densities[i] =
          (1 - kEvenShare) * weights[i] / total_power + kEvenShare / (materials * areas[i]);
  return densities;
}

}  // namespace

double areaOf(const Scene& scene, const Triangle& triangle) {
  const glm::dvec3 a(scene.positions[triangle.positions[0]]);
  const glm::dvec3 b(scene.positions[triangle.positions[1]]);
  const glm::dvec3 c(scene.positions[triangle.positions[2]]);
  return 0.5 * glm::length(glm::cross(b - a, c - a));
}

double emissionWeight(const Scene& scene, const Material& material) {
  // A picture that is black, or nearly, still may have a bright spot.
  constexpr float kLeastMean = 1e-3f;
  if (material.unlit) return 0;
  glm::dvec3 e(material.emission);
  if (material.emission_texture.used())
    e *= glm::max(meanOfColors(scene.images[material.emission_texture.image]), Vec3(kLeastMean));
  return (e.r + e.g + e.b) / 3 * (material.double_sided ? 2 : 1);
}

LightTable buildLightTable(const Scene& scene) {
  LightTable table;
  std::vector<double> weights;
  for (const Material& material : scene.materials)
    weights.push_back(emissionWeight(scene, material));
  const std::vector<double> areas = emittingAreas(scene, weights);
  table.densities = densitiesOf(weights, areas);
  table.power = std::numbers::pi * powerOf(weights, areas);
  std::vector<double> shares;
  std::vector<std::uint32_t> triangles;
  for (std::uint32_t i = 0; i < scene.triangles.size(); ++i) {
    const Triangle& triangle = scene.triangles[i];
    if (!(areas[triangle.material] > 0)) continue;
    triangles.push_back(i);
    shares.push_back(areaOf(scene, triangle) * table.densities[triangle.material]);
  }
  const std::vector<AliasEntry> aliases = buildAliasTable(shares);
  for (std::size_t i = 0; i < aliases.size(); ++i)
    table.entries.push_back({aliases[i].share, triangles[i], triangles[aliases[i].other]});
  return table;
}

}  // namespace glimt
