// Which triangle a light sample goes to.
#pragma once

#include <cstdint>
#include <vector>

#include "renderer/scene/scene.h"

namespace glimt {

// Of an alias table; see alias_table.h.
struct LightEntry {
  float share = 1;
  std::uint32_t triangle = 0;  // both into Scene::triangles
  std::uint32_t other_triangle = 0;
};

struct LightTable {
  std::vector<LightEntry> entries;  // one per triangle that emits
  double total_power = 0;           // sum of area * emissionWeight, square metres * radiance
};

// Square metres.
double areaOf(const Scene& scene, const Triangle& triangle);

// The radiance by which a material's triangles are chosen, per area: the mean of the channels,
// twice that where both sides emit.
float emissionWeight(const Material& material);

// Density of light samples on a surface of this material, per square metre.
float lightDensity(const LightTable& table, const Material& material);

// Triangles in proportion to area * emissionWeight.
LightTable buildLightTable(const Scene& scene);

}  // namespace glimt
