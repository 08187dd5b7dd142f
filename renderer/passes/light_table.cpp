#include "renderer/passes/light_table.h"

namespace glimt {
namespace {

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

}  // namespace

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
  for (std::uint32_t i = 0; i < scene.triangles.size(); ++i) {
    const Triangle& triangle = scene.triangles[i];
    const float weight = emissionWeight(scene.materials[triangle.material]);
    if (!(weight > 0)) continue;
    table.entries.push_back({1.0f, i, i});
    powers.push_back(areaOf(scene, triangle) * weight);
    table.total_power += powers.back();
  }
  const double mean = table.total_power / static_cast<double>(powers.size());
  for (double& power : powers) power /= mean;
  fillAliases(table.entries, std::move(powers));
  return table;
}

}  // namespace glimt
