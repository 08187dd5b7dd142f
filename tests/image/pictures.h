// Renders for tests.
#pragma once

#include <array>
#include <glm/vec3.hpp>

#include "renderer/renderer.h"

namespace glimt::test {

RenderSettings settingsFor(int size, int bounces, std::uint32_t seed = 1);

// Of what three seeds give. The last surface of a path samples lights only; where walls that emit
// meet in an edge the variance of that has no bound, and one sample can weigh as much as thousands.
double middleOf(std::array<double, 3> values);

Image render(const Scene& scene, const RenderSettings& settings, int samples,
             Backend backend = Backend::egl);

glm::dvec3 meanOf(const Image& image);

// The same numbers, to the last bit.
bool identical(const Image& a, const Image& b);

// The smallest mean of any block of that many pixels a side, over all channels.
double darkestBlock(const Image& image, int side);

}  // namespace glimt::test
