// Renders for tests.
#pragma once

#include <algorithm>
#include <array>
#include <glm/vec3.hpp>

#include "renderer/renderer.h"

namespace glimt::test {

RenderSettings settingsFor(int size, int bounces, std::uint32_t seed = 1);

// Of what `measure` finds with three seeds. The last surface of a path samples lights only; where
// walls that emit meet in an edge the variance of that has no bound, and one sample can weigh as
// much as thousands.
template <typename Measure>
double middleOfThreeSeeds(const Measure& measure) {
  std::array<double, 3> found{measure(1u), measure(2u), measure(3u)};
  std::sort(found.begin(), found.end());
  return found[1];
}

Image render(const Scene& scene, const RenderSettings& settings, int samples,
             Backend backend = Backend::egl);

glm::dvec3 meanOf(const Image& image);

// The same numbers, to the last bit.
bool identical(const Image& a, const Image& b);

// The smallest mean of any block of that many pixels a side, over all channels.
double darkestBlock(const Image& image, int side);

}  // namespace glimt::test
