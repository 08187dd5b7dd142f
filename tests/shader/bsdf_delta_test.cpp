// Surfaces without roughness: exact mirrors, exact refraction, and boundaries that are not there.
#include <algorithm>
#include <catch2/catch.hpp>

#include "tests/shader/bsdfs.h"
#include "tests/shader/glsl_float.h"

using namespace glimt;
using namespace glimt::test;

namespace {

// Of samples with the same wo, all that are singular.
template <class Check>
int forSingleDirections(const Surface& s, Check&& check) {
  Random random(4);
  int found = 0;
  for (const double cosine : {1e-3, 0.1, 0.5, 0.99, 1.0}) {
    const auto bsdf = bsdfOf<glsl_float::Bsdf>(s, cosine);
    const glm::vec3 wo(directionOf(cosine));
    for (int i = 0; i < 200; ++i) {
      const auto sample =
          glsl_float::sampleBsdf(bsdf, wo, {random.uniform(), random.uniform(), random.uniform()});
      if (sample.pdf < glsl_float::PDF_DELTA) continue;
      ++found;
      check(wo, sample);
    }
  }
  return found;
}

double schlick(double normal, double cosine) {
  return normal + (1 - normal) * std::pow(1 - cosine, 5);
}

}  // namespace

TEST_CASE("without roughness a metal is an exact mirror whose weight is Fresnel's") {
  Surface s;
  s.metallic = 1;
  s.roughness = 0;
  s.base_color = glm::dvec3(0.6);
  const int found = forSingleDirections(s, [](const glm::vec3& wo, const auto& sample) {
    CHECK(glm::length(sample.wi - glm::vec3(-wo.x, -wo.y, wo.z)) < 1e-6f);
    CHECK(sample.weight.x == Approx(schlick(0.6, wo.z)).epsilon(1e-4));
  });
  CHECK(found == 1000);
}

TEST_CASE("a smooth coat over black is an exact mirror whose weight is Fresnel's") {
  Surface s;
  s.base_color = glm::dvec3(0);
  s.clearcoat = 1;
  const int found = forSingleDirections(s, [](const glm::vec3& wo, const auto& sample) {
    CHECK(glm::length(sample.wi - glm::vec3(-wo.x, -wo.y, wo.z)) < 1e-6f);
    CHECK(sample.weight.x == Approx(schlick(0.04, wo.z)).epsilon(1e-4));
  });
  CHECK(found == 1000);
}

TEST_CASE("an index of refraction of 1 is invisible, thin or not") {
  Surface s;
  s.specular = 1;
  s.transmission = 1;
  s.roughness = 0;
  s.ior = 1;
  s.thin = GENERATE(false, true);
  const int found = forSingleDirections(s, [](const glm::vec3& wo, const auto& sample) {
    CHECK(glm::length(sample.wi + wo) < 1e-6f);
    CHECK(sample.weight.x == Approx(1));
  });
  CHECK(found == 1000);
  s.transmission = 0;
  CHECK(albedoOf(s, 0.05) == Approx(1));
  s.base_color = glm::dvec3(0);
  CHECK(albedoOf(s, 0.05) == 0);
}

TEST_CASE("a smooth thin wall lets light straight through") {
  Surface s;
  s.transmission = 1;
  s.roughness = 0;
  s.thin = true;
  forSingleDirections(s, [](const glm::vec3& wo, const auto& sample) {
    const bool straight = glm::length(sample.wi + wo) < 1e-6f;
    CHECK((straight || glm::length(sample.wi - glm::vec3(-wo.x, -wo.y, wo.z)) < 1e-6f));
  });
}

TEST_CASE("smooth glass bends light by Snell's law") {
  Surface s;
  s.transmission = 1;
  s.roughness = 0;
  s.ior = 1.5;
  s.inside = GENERATE(false, true);
  forSingleDirections(s, [&s](const glm::vec3& wo, const auto& sample) {
    if (sample.wi.z > 0) return;
    const double sine_out = std::hypot(wo.x, wo.y);
    const double sine_in = std::hypot(sample.wi.x, sample.wi.y);
    CHECK(sine_in * (s.inside ? 1 / s.ior : s.ior) == Approx(sine_out).margin(1e-6));
  });
}
