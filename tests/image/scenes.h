// Small scenes whose pictures are known.
#pragma once

#include "renderer/scene/scene.h"

namespace glimt::test {

Material lambert(const std::string& name, const Vec3& base_color, const Vec3& emission = Vec3(0));

// Adds a material and returns its index.
std::uint32_t add(Scene& scene, const Material& material);

// Counter-clockwise seen from its front.
void addTriangle(Scene& scene, const Vec3& a, const Vec3& b, const Vec3& c, std::uint32_t material);

// Two triangles, counter-clockwise seen from where cross(edge1, edge2) points to.
void addQuad(Scene& scene, const Vec3& corner, const Vec3& edge1, const Vec3& edge2,
             std::uint32_t material);

// A cube of that half width around the origin, its front sides outside, or inside for `inwards`.
void addCube(Scene& scene, float half_width, std::uint32_t material, bool inwards = false);

// A sphere of 8 * 4^levels flat triangles around the origin.
void addSphere(Scene& scene, float radius, int levels, std::uint32_t material);

// A closed cube seen from inside: every wall emits 1 and reflects `albedo`. A path of B secondary
// bounces collects the sum of albedo^k for k = 0 to B + 1, the same in every pixel.
Scene furnace(float albedo);
double furnaceRadiance(double albedo, int bounces);

}  // namespace glimt::test
