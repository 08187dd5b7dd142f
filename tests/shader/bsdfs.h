// Surfaces of bsdf_layered.glsl, and sums over what they do with light. All in double, but for the
// functions that take a precision's own types.
#pragma once

#include <fmt/format.h>

#include <string>
#include <vector>

#include "renderer/passes/gloss_table.h"
#include "renderer/passes/sheen_albedo.h"
#include "tests/shader/glsl_double.h"
#include "tests/shader/random.h"

namespace glimt::test {

// As a material says it; `inside` is where the path comes from.
struct Surface {
  std::string name;
  glm::dvec3 base_color{1};
  double metallic = 0;
  double roughness = 0.5;
  double specular = 0;
  double ior = 1.5;
  double transmission = 0;
  bool inside = false;
  bool thin = false;
  double sheen = 0;
  double sheen_roughness = 0.5;
  double clearcoat = 0;
  double clearcoat_roughness = 0;
};

// The shaders' Bsdf of either precision, for a direction wo whose cosine is given. With exact
// albedos in place of the table's.
template <class B>
B bsdfOf(const Surface& s, double cosine) {
  using Vector = decltype(B{}.base_color);
  using Number = typename Vector::value_type;
  const auto number = [](double x) { return static_cast<Number>(x); };
  B bsdf{};
  bsdf.base_color = Vector(s.base_color);
  bsdf.metallic = number(s.metallic);
  bsdf.roughness = number(s.roughness);
  bsdf.specular = number(s.specular);
  bsdf.ior = number(s.inside && !s.thin ? 1 / s.ior : s.ior);
  bsdf.transmission = number(s.transmission);
  bsdf.gloss_albedo = decltype(bsdf.gloss_albedo)(glossAlbedoOf(cosine, s.roughness));
  if (s.transmission > 0 && s.roughness > 0)
    bsdf.glass_albedo = number(glassAlbedoOf(cosine, s.roughness, s.inside ? 1 / s.ior : s.ior));
  bsdf.thin = number(s.thin ? 1 : 0);
  bsdf.sheen.color = Vector(number(s.sheen));
  bsdf.sheen.roughness = number(s.sheen_roughness);
  bsdf.sheen.albedo = number(sheenAlbedoOf(cosine, s.sheen_roughness));
  bsdf.coat.strength = number(s.clearcoat);
  bsdf.coat.roughness = number(s.clearcoat_roughness);
  bsdf.coat.albedo = decltype(bsdf.coat.albedo)(glossAlbedoOf(cosine, s.clearcoat_roughness));
  return bsdf;
}

inline glm::dvec3 directionOf(double cosine, double turn = 0.7) {
  const double sine = std::sqrt(1 - cosine * cosine);
  return {sine * std::cos(turn), sine * std::sin(turn), cosine};
}

// One point of a regular grid of count^3 that is shifted within its cell.
inline glm::dvec3 stratified(int x, int y, int z, int count, Random& random) {
  const glm::dvec3 shift(random.uniform(), random.uniform(), random.uniform());
  return (glm::dvec3(x, y, z) + shift) / static_cast<double>(count);
}

// What share of the light from wo comes out again, as sampleBsdf tells: the mean of its weights.
inline double albedoOf(const Surface& s, double cosine, int count = 20) {
  const auto bsdf = bsdfOf<glsl_double::Bsdf>(s, cosine);
  const glm::dvec3 wo = directionOf(cosine);
  Random random(7);
  double sum = 0;
  for (int x = 0; x < count; ++x)
    for (int y = 0; y < count; ++y)
      for (int z = 0; z < count; ++z)
        sum += glsl_double::sampleBsdf(bsdf, wo, stratified(x, y, z, count, random)).weight.x;
  return sum / (count * count * count);
}

// Every lobe alone, and mixtures.
inline std::vector<Surface> kindsOfSurface() {
  std::vector<Surface> kinds(14);
  kinds[0].name = "Lambert";
  kinds[1] = {.name = "metal", .metallic = 1};
  kinds[2] = {.name = "dielectric over white", .specular = 1};
  kinds[3] = {.name = "dielectric over black", .base_color = glm::dvec3(0), .specular = 1};
  kinds[4] = {.name = "half metal", .metallic = 0.5, .specular = 1};
  kinds[5] = {.name = "glass", .specular = 1, .transmission = 1};
  kinds[6] = {.name = "glass, inside", .specular = 1, .transmission = 1, .inside = true};
  kinds[7] = {.name = "half glass", .specular = 1, .transmission = 0.5};
  kinds[8] = {.name = "thin wall", .specular = 1, .transmission = 1, .thin = true};
  kinds[9] = {.name = "sheen over Lambert", .sheen = 1};
  kinds[10] = {.name = "sheen over black", .base_color = glm::dvec3(0), .sheen = 1};
  kinds[11] = {.name = "smooth coat over Lambert", .clearcoat = 1};
  kinds[12] = {
      .name = "rough coat over metal", .metallic = 1, .clearcoat = 1, .clearcoat_roughness = 0.4};
  kinds[13] = {.name = "everything",
               .metallic = 0.25,
               .specular = 0.8,
               .transmission = 0.5,
               .sheen = 0.5,
               .sheen_roughness = 0.3,
               .clearcoat = 0.5,
               .clearcoat_roughness = 0.2};
  return kinds;
}

}  // namespace glimt::test
