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
  std::vector<double> densities;    // of samples on each material, per square metre; into
                                    // Scene::materials
  double power = 0;                 // of all triangles, mean of the channels, watts
};

// Square metres.
double areaOf(const Scene& scene, const Triangle& triangle);

// The radiance by which a material's triangles are chosen, per area: the mean of the channels, and
// of the picture where it has one; twice that where both sides emit. 0 for an unlit material, which
// is no light.
double emissionWeight(const Scene& scene, const Material& material);

// Most samples go to triangles in proportion to their power, area * emissionWeight. A fifth is
// dealt out evenly among the materials that emit: where only a weak light arrives, it is found all
// the same, however much brighter others are.
LightTable buildLightTable(const Scene& scene);

}  // namespace glimt
