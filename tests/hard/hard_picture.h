// Pictures on the driver under test, and what is expected of them.
#pragma once

#include <vector>

#include "renderer/core/image.h"
#include "renderer/renderer.h"

namespace glimt::test {

// Checks that no sample was lost.
Image hardPicture(const Scene& scene, const RenderSettings& settings, int samples);

// Mean over all pixels and channels.
double meanRadiance(const Image& image);

// The largest channel of any pixel.
double brightest(const Image& image);

// |measured / expected - 1|
double relativeError(double measured, double expected);

// Points the camera at a spot so small that its irradiance is even.
void lookAtSpot(Scene& scene, const Vec3& eye, const Vec3& spot);

// Irradiance at a point from an even polygon that shines on it, wholly above the surface of that
// unit normal: Lambert's sum over the edges.
double polygonIrradiance(const std::vector<glm::dvec3>& polygon, const glm::dvec3& point,
                         const glm::dvec3& normal, double radiance);

}  // namespace glimt::test
