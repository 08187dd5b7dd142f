// sampleBsdf against pdfBsdf and evalBsdf: chi-square of the directions, and weights.
#include <algorithm>
#include <array>
#include <catch2/catch.hpp>
#include <map>

#include "tests/shader/bsdfs.h"
#include "tests/shader/report.h"

using namespace glimt;
using namespace glimt::test;
using glsl_double::evalBsdf;
using glsl_double::pdfBsdf;
using glsl_double::sampleBsdf;

namespace {

constexpr int kHeights = 24;  // of the whole sphere's cells, in equal steps of the cosine
constexpr int kTurns = 24;
constexpr int kSamples = 200000;

struct Cells {
  std::array<double, static_cast<std::size_t>(kHeights* kTurns)> counts{};
  double none = 0;  // samples that stand for nothing, or for a single direction: of no density
};

Cells sampled(const glsl_double::Bsdf& bsdf, const glm::dvec3& wo) {
  Cells cells;
  Random random(11);
  for (int i = 0; i < kSamples; ++i) {
    const auto sample =
        sampleBsdf(bsdf, wo, {random.uniform(), random.uniform(), random.uniform()});
    const bool nothing = sample.weight == glm::dvec3(0) && sample.wi == glm::dvec3(0, 0, 1);
    if (nothing || sample.pdf >= glsl_double::PDF_DELTA) {
      ++cells.none;
      continue;
    }
    const double turn = std::atan2(sample.wi.y, sample.wi.x) / (2 * std::numbers::pi) + 0.5;
    const int row = std::clamp(static_cast<int>((sample.wi.z + 1) / 2 * kHeights), 0, kHeights - 1);
    const int column = std::clamp(static_cast<int>(turn * kTurns), 0, kTurns - 1);
    ++cells.counts[static_cast<std::size_t>(row * kTurns + column)];
  }
  return cells;
}

// The integral of the density over a cell, by `steps` squared points.
double integral(const glsl_double::Bsdf& bsdf, const glm::dvec3& wo, int row, int column,
                int steps) {
  double sum = 0;
  for (int i = 0; i < steps; ++i)
    for (int j = 0; j < steps; ++j) {
      const double z = -1 + 2 * (row + (i + 0.5) / steps) / kHeights;
      const double turn = 2 * std::numbers::pi * ((column + (j + 0.5) / steps) / kTurns - 0.5);
      const double radius = std::sqrt(1 - z * z);
      sum += pdfBsdf(bsdf, wo, {radius * std::cos(turn), radius * std::sin(turn), z});
    }
  return sum * 4 * std::numbers::pi / (kHeights * kTurns) / (steps * steps);
}

// Pearson's, of the cells with at least five samples expected, the others taken together, as
// standard deviations from its mean (Wilson and Hilferty's normal approximation).
double chiSquareDeviations(const glsl_double::Bsdf& bsdf, const glm::dvec3& wo) {
  const Cells cells = sampled(bsdf, wo);
  double chi2 = 0, freedom = -1, few_expected = 0, few_found = 0, all_expected = 0;
  const auto compare = [&](double expected, double found) {
    chi2 += (found - expected) * (found - expected) / expected;
    ++freedom;
  };
  for (int row = 0; row < kHeights; ++row)
    for (int column = 0; column < kTurns; ++column) {
      const double found = cells.counts[static_cast<std::size_t>(row * kTurns + column)];
      double expected = kSamples * integral(bsdf, wo, row, column, 4);
      if (expected > 1) expected = kSamples * integral(bsdf, wo, row, column, 24);
      all_expected += expected;
      if (expected >= 5) {
        compare(expected, found);
      } else {
        few_expected += expected;
        few_found += found;
      }
    }
  if (few_expected >= 5) compare(few_expected, few_found);
  const double none_expected = kSamples - all_expected;
  if (none_expected >= 5) compare(none_expected, cells.none);
  if (freedom < 1) return 0;
  const double k = 2 / (9 * freedom);
  return (std::cbrt(chi2 / freedom) - (1 - k)) / std::sqrt(k);
}

std::vector<Surface> roughSurfaces() {
  std::vector<Surface> surfaces;
  for (Surface s : kindsOfSurface())
    for (const double roughness : {0.4, 0.8}) {
      if (roughness < 0.5 && s.name == "Lambert") continue;
      s.roughness = roughness;
      surfaces.push_back(s);
    }
  return surfaces;
}

}  // namespace

TEST_CASE("directions of every lobe and mixture are as dense as the pdf says") {
  double worst = 0;
  std::string where;
  for (const Surface& s : roughSurfaces())
    for (const double cosine : {0.2, 0.8}) {
      const auto bsdf = bsdfOf<glsl_double::Bsdf>(s, cosine);
      const double deviations = chiSquareDeviations(bsdf, directionOf(cosine));
      INFO(s.name << ", roughness " << s.roughness << ", cosine " << cosine);
      // One test in half a million would fail by chance.
      CHECK(deviations < 5);
      if (deviations > worst)
        where = fmt::format("{}, roughness {}, cosine {}", s.name, s.roughness, cosine);
      worst = std::max(worst, deviations);
    }
  report("chi-square of {} samples in {} cells: at most {:.2f} standard deviations, {}", kSamples,
         kHeights * kTurns, worst, where);
}

TEST_CASE("the weight of a sample is what eval and pdf say of its direction") {
  double worst = 0;
  for (const Surface& s : roughSurfaces()) {
    Random random(3);
    for (int i = 0; i < 2000; ++i) {
      const double cosine = random.uniform(0.01f, 1);
      const auto bsdf = bsdfOf<glsl_double::Bsdf>(s, cosine);
      const glm::dvec3 wo = directionOf(cosine);
      const auto sample =
          sampleBsdf(bsdf, wo, {random.uniform(), random.uniform(), random.uniform()});
      if (sample.pdf >= glsl_double::PDF_DELTA || sample.weight == glm::dvec3(0)) continue;
      const glm::dvec3 eval = evalBsdf(bsdf, wo, sample.wi);
      const double pdf = pdfBsdf(bsdf, wo, sample.wi);
      worst = std::max(worst, std::abs(sample.pdf / pdf - 1));
      worst = std::max(worst, std::abs(sample.weight.x * pdf / eval.x - 1));
    }
  }
  CHECK(worst < 1e-9);
}
