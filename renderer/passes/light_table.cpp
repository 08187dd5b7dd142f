#include "renderer/passes/light_table.h"

#include "renderer/passes/alias_table.h"

namespace glimt {
double areaOf(const Scene& scene, const Triangle& triangle) {
  const glm::dvec3 a(scene.positions[triangle.positions[0]]);
  const glm::dvec3 b(scene.positions[triangle.positions[1]]);
  const glm::dvec3 c(scene.positions[triangle.positions[2]]);
  return 0.5 * glm::length(glm::cross(b - a, c - a));
}

float emissionWeight(const Material& material) {
  const Vec3& e = material.emission;
  return (e.r + e.g + e.b) / 3 * (material.double_sided ? 2.0f : 1.0f);
}

float lightDensity(const LightTable& table, const Material& material) {
  if (!(table.total_power > 0)) return 0;
  return static_cast<float>(emissionWeight(material) / table.total_power);
}

LightTable buildLightTable(const Scene& scene) {
  LightTable table;
  std::vector<double> powers;
  std::vector<std::uint32_t> triangles;
  for (std::uint32_t i = 0; i < scene.triangles.size(); ++i) {
    const Triangle& triangle = scene.triangles[i];
    const float weight = emissionWeight(scene.materials[triangle.material]);
    if (!(weight > 0)) continue;
    triangles.push_back(i);
    powers.push_back(areaOf(scene, triangle) * weight);
    table.total_power += powers.back();
  }
  const std::vector<AliasEntry> aliases = buildAliasTable(powers);
  for (std::size_t i = 0; i < aliases.size(); ++i)
    table.entries.push_back({aliases[i].share, triangles[i], triangles[aliases[i].other]});
  return table;
}

}  // namespace glimt
