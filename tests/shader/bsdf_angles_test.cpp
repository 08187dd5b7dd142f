// Reciprocity, and directions and numbers that are hard to compute with.
#include <algorithm>
#include <catch2/catch.hpp>

#include "tests/shader/bsdfs.h"
#include "tests/shader/glsl_float.h"
#include "tests/shader/report.h"

using namespace glimt;
using namespace glimt::test;

namespace {

namespace exact = glsl_double;

glm::dvec3 above(Random& random) {
  return directionOf(random.uniform(0.02f, 1), random.uniform(0, 6.28f));
}

// By how much f(a, b) differs from f(b, a), relative to the larger. Both are times the cosine of
// their second direction.
double asymmetry(double forth, double forth_cosine, double back, double back_cosine) {
  const double f = forth / forth_cosine;
  const double b = back / back_cosine;
  return f == b ? 0 : std::abs(f - b) / std::max(std::abs(f), std::abs(b));
}

bool isSound(const glm::vec3& v) {
  return v.x >= 0 && v.y >= 0 && v.z >= 0 && std::isfinite(v.x + v.y + v.z);
}

}  // namespace

TEST_CASE("gloss that is not compensated, sheen and thin walls look the same from either end") {
  Random random(5);
  double gloss = 0, sheen = 0, wall = 0;
  for (int i = 0; i < 20000; ++i) {
    const glm::dvec3 a = above(random);
    const glm::dvec3 b = above(random);
    const double alpha = random.uniform(0.01f, 1);
    // Microfacets that reflect all of what they reflect once: nothing to add.
    const glm::dvec2 whole(1, 0);
    const glm::dvec3 f0(0.3);
    gloss = std::max(gloss, asymmetry(exact::evalGloss(a, b, alpha, f0, 1, whole).x, b.z,
                                      exact::evalGloss(b, a, alpha, f0, 1, whole).x, a.z));
    sheen = std::max(sheen, asymmetry(exact::evalWhiteSheen(a, b, alpha), b.z,
                                      exact::evalWhiteSheen(b, a, alpha), a.z));
    const glm::dvec3 below(b.x, b.y, -b.z);
    // Seen from below, what was above is below.
    wall = std::max(wall, asymmetry(exact::evalThinWall(a, below, alpha, 1.5, 1), b.z,
                                    exact::evalThinWall(b, {a.x, a.y, -a.z}, alpha, 1.5, 1), a.z));
  }
  report("relative asymmetry: gloss {:.2g}, sheen {:.2g}, thin walls {:.2g}", gloss, sheen, wall);
  CHECK(gloss < 1e-9);
  CHECK(sheen < 1e-9);
  CHECK(wall < 1e-9);
}

TEST_CASE("rough glass looks the same from either side, but for the square of the index") {
  Random random(6);
  double reflected = 0, through = 0;
  int pairs = 0;
  for (int i = 0; i < 50000; ++i) {
    const glm::dvec3 a = above(random);
    const glm::dvec3 b = above(random);
    const double alpha = random.uniform(0.05f, 1);
    const double ior = random.uniform(1.1f, 2.5f);
    reflected = std::max(reflected, asymmetry(exact::evalRoughGlass(a, b, alpha, ior, 1), b.z,
                                              exact::evalRoughGlass(b, a, alpha, ior, 1), a.z));
    // Upside down, from the other side.
    const double forth = exact::evalRoughGlass(a, {b.x, b.y, -b.z}, alpha, ior, 1);
    const double back = exact::evalRoughGlass(b, {a.x, a.y, -a.z}, alpha, 1 / ior, 1);
    if (!(forth > 1e-12)) continue;
    ++pairs;
    // Radiance is not scaled, so f / n^2 of the far side is symmetric.
    through = std::max(through, asymmetry(forth / (ior * ior), b.z, back, a.z));
  }
  report("relative asymmetry of rough glass: reflected {:.2g}, through {:.2g} of {} pairs",
         reflected, through, pairs);
  CHECK(reflected < 1e-7);
  CHECK(pairs > 1000);
  CHECK(through < 1e-6);
}

// What is scaled by the albedo of one of the two directions: the diffuse base below a boundary,
// what lies below fibres and a coat, and what is added to gloss for the light reflected more than
// once. A symmetric form would need the albedo of the other direction too, which light samples do
// not have.
TEST_CASE("what is below a boundary, and compensated gloss, are not the same from either end") {
  Surface coated;
  coated.specular = 1;
  const glm::dvec3 a = directionOf(0.1);
  const glm::dvec3 b = directionOf(0.9, 3);
  const auto f = [&](const glm::dvec3& wo, const glm::dvec3& wi) {
    return exact::evalBsdf(bsdfOf<exact::Bsdf>(coated, wo.z), wo, wi).x;
  };
  CHECK(asymmetry(f(a, b), b.z, f(b, a), a.z) > 0.01);
}

TEST_CASE("nothing is negative or not a number, however extreme") {
  Random random(8);
  const auto pick = [&](const std::vector<float>& values) {
    return values[random.below(static_cast<std::uint32_t>(values.size()))];
  };
  const std::vector<float> roughnesses{0, 1e-4f, 1e-3f, 0.01f, 0.1f, 0.5f, 1};
  const std::vector<float> shares{0, 1e-6f, 0.3f, 0.999f, 1};
  const std::vector<float> cosines{1e-4f, 1e-3f, 0.01f, 0.3f, 0.9999f, 1};
  const std::vector<float> randoms{0, 0x1p-23f, 0.25f, 0.5f, 0.75f, 0.99999988f};
  int bad = 0;
  for (int i = 0; i < 30000; ++i) {
    Surface s;
    s.base_color = glm::dvec3(pick(shares), pick(shares), pick(shares));
    s.metallic = pick(shares);
    s.roughness = pick(roughnesses);
    s.specular = pick(shares);
    s.ior = pick({1, 1.0001f, 1.5f, 2.5f, 1000});
    s.transmission = pick(shares);
    s.inside = random.below(2) == 1;
    s.thin = random.below(2) == 1;
    s.sheen = pick(shares);
    s.sheen_roughness = pick(roughnesses);
    s.clearcoat = pick(shares);
    s.clearcoat_roughness = pick(roughnesses);
    const float cosine = pick(cosines);
    const glm::vec3 wo(glm::normalize(directionOf(cosine, random.uniform(0, 6.28f))));
    const auto bsdf = bsdfOf<glsl_float::Bsdf>(s, cosine);
    const auto sample =
        glsl_float::sampleBsdf(bsdf, wo, {pick(randoms), pick(randoms), random.uniform()});
    const glm::vec3 wi = random.below(2) == 1 ? sample.wi : random.direction();
    const float pdf = glsl_float::pdfBsdf(bsdf, wo, wi);
    const bool sound =
        isSound(sample.weight) && isSound(glsl_float::evalBsdf(bsdf, wo, wi)) && pdf >= 0 &&
        std::isfinite(pdf) && sample.pdf > 0 && sample.pdf <= glsl_float::PDF_DELTA &&
        std::abs(glm::length(sample.wi) - 1) < 1e-3f && sample.random >= 0 && sample.random < 1;
    if (sound) continue;
    if (++bad > 5) continue;
    FAIL_CHECK(fmt::format(
        "color {} metallic {} roughness {} specular {} ior {} transmission {} inside {} "
        "thin {} sheen {} {} coat {} {}, cosine {}: weight {} {} {} pdf {} wi {} {} {} "
        "length-1 {} random {}",
        s.base_color.x, s.metallic, s.roughness, s.specular, s.ior, s.transmission, s.inside,
        s.thin, s.sheen, s.sheen_roughness, s.clearcoat, s.clearcoat_roughness, cosine,
        sample.weight.x, sample.weight.y, sample.weight.z, sample.pdf, sample.wi.x, sample.wi.y,
        sample.wi.z, glm::length(sample.wi) - 1, sample.random));
  }
  CHECK(bad == 0);
}

// Of two directions that are nearly opposite, the half vector is known to few digits only, and may
// lead away from either. What the density takes for nothing then, the reflectance must not take for
// a peak.
TEST_CASE("no sampled direction weighs more than a few, however flat the light comes in") {
  Random random(9);
  for (Surface s : kindsOfSurface()) {
    float most = 0;
    for (const double roughness : {0.1, 0.2, 0.3, 0.55, 1.0})
      for (const double cosine : {1e-4, 1e-3, 1e-2}) {
        s.roughness = roughness;
        if (s.clearcoat_roughness > 0) s.clearcoat_roughness = roughness;
        const auto bsdf = bsdfOf<glsl_float::Bsdf>(s, cosine);
        for (int i = 0; i < 20000; ++i) {
          const glm::vec3 wo(directionOf(cosine, random.uniform(0, 6.28f)));
          const auto sample = glsl_float::sampleBsdf(
              bsdf, wo, {random.uniform(), random.uniform(), random.uniform()});
          most = std::max({most, sample.weight.x, sample.weight.y, sample.weight.z});
        }
      }
    report("{}: weights of up to {:.3g}", s.name, most);
    INFO(s.name);
    CHECK(most < 10);
  }
}
