#include "renderer/passes/light_table.h"

namespace glimt {
namespace {

// Of the samples, that is dealt out evenly among materials. It makes the noise of the brightest
// light larger by an eighth at the most.
constexpr double kEvenShare = 0.2;

// Entries with less than the mean give what they lack to one with more.
void fillAliases(std::vector<LightEntry>& entries, std::vector<double> scaled) {
  std::vector<std::uint32_t> poor;
  std::vector<std::uint32_t> rich;
  for (std::uint32_t i = 0; i < entries.size(); ++i) (scaled[i] < 1 ? poor : rich).push_back(i);
  while (!poor.empty() && !rich.empty()) {
    const std::uint32_t taker = poor.back();
    const std::uint32_t giver = rich.back();
    poor.pop_back();
    entries[taker].share = static_cast<float>(scaled[taker]);
    entries[taker].other_triangle = entries[giver].triangle;
    scaled[giver] -= 1 - scaled[taker];
    if (scaled[giver] < 1) {
      rich.pop_back();
      poor.push_back(giver);
    }
  }
  // What is left differs from one by rounding only, and keeps a share of one.
}

// Of each material that emits, in square metres; 0 for the others.
std::vector<double> emittingAreas(const Scene& scene) {
  std::vector<double> areas(scene.materials.size());
  for (const Triangle& triangle : scene.triangles)
    if (emissionWeight(scene.materials[triangle.material]) > 0)
      areas[triangle.material] += areaOf(scene, triangle);
  return areas;
}

// Of samples on each material. Their integral over all areas is 1.
std::vector<double> densitiesOf(const Scene& scene, const std::vector<double>& areas) {
  double total_power = 0;
  double materials = 0;
  for (std::size_t i = 0; i < areas.size(); ++i) {
    total_power += areas[i] * emissionWeight(scene.materials[i]);
    materials += areas[i] > 0;
  }
  std::vector<double> densities(areas.size());
  for (std::size_t i = 0; i < areas.size(); ++i)
    if (areas[i] > 0)
      densities[i] = (1 - kEvenShare) * emissionWeight(scene.materials[i]) / total_power +
                     kEvenShare / (materials * areas[i]);
  return densities;
}

}  // namespace

double areaOf(const Scene& scene, const Triangle& triangle) {
  const glm::dvec3 a(scene.positions[triangle.positions[0]]);
  const glm::dvec3 b(scene.positions[triangle.positions[1]]);
  const glm::dvec3 c(scene.positions[triangle.positions[2]]);
  return 0.5 * glm::length(glm::cross(b - a, c - a));
}

double emissionWeight(const Material& material) {
  const glm::dvec3 e(material.emission);
  return (e.r + e.g + e.b) / 3 * (material.double_sided ? 2 : 1);
}

LightTable buildLightTable(const Scene& scene) {
  LightTable table;
  const std::vector<double> areas = emittingAreas(scene);
  table.densities = densitiesOf(scene, areas);
  std::vector<double> shares;
  for (std::uint32_t i = 0; i < scene.triangles.size(); ++i) {
    const Triangle& triangle = scene.triangles[i];
    if (!(areas[triangle.material] > 0)) continue;
    table.entries.push_back({1.0f, i, i});
    shares.push_back(areaOf(scene, triangle) * table.densities[triangle.material]);
  }
  for (double& share : shares) share *= static_cast<double>(shares.size());
  fillAliases(table.entries, std::move(shares));
  return table;
}

}  // namespace glimt
