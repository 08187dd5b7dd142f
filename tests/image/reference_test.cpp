// The reference pictures that another renderer made. The short tests guard against regressions, the
// long ones ([long]) are the full comparison at 1024 samples.
#include <catch2/catch.hpp>

#include <iostream>

#include "renderer/scene/load_scene.h"
#include "tests/image/pictures.h"
#include "tests/image/reference_comparison.h"

using namespace glimt;
using namespace glimt::test;

namespace {

// A scene, and what the README of the reference pictures says of it.
struct Reference {
  std::string name;
  float light;          // its brightest channel; 0: none that has to be masked
  double relative_mse;  // of a plain path tracer with pseudo-random numbers at 1024 samples
};

const Reference kCornell{"cornell", 17, 1.5e-4};
const Reference kKnot{"knot", 17, 4.4e-4};
const Reference kGlass{"glass", 4, 5.9e-4};
const Reference kSky{"sky", 1e9f, 1.1e-3};
const Reference kMirrorGloss{"mirror_gloss", 6, 1.3e-3};

ReferenceComparison renderAndCompare(const std::filesystem::path& folder,
                                     const Reference& reference, int samples) {
  const std::string& name = reference.name;
  const Scene scene = loadScene(folder / (name + ".scene.json"));
  const Image image = render(scene, settingsFor(256, scene.render.bounces.value()), samples);
  const ReferenceComparison c = compareWithReference(image, folder, name, reference.light);
  std::cout << name << ", " << samples << " samples: mean ratio " << c.mean_ratio.r << " "
            << c.mean_ratio.g << " " << c.mean_ratio.b << ", relMSE " << c.relative_mse
            << " (of it the reference's " << c.reference_mse << "), median block "
            << c.median_block_ratio << ", blocks within 2% " << c.blocks_within_2_percent << "\n";
  return c;
}

// The relative error may be `times` that of a plain path tracer at that number of samples.
void check(const ReferenceComparison& c, double mean_bound, const Reference& reference, int samples,
           double times = 1) {
  for (int channel = 0; channel < 3; ++channel) {
    CHECK(c.mean_ratio[channel] > 1 - mean_bound);
    CHECK(c.mean_ratio[channel] < 1 + mean_bound);
  }
  CHECK(c.relative_mse - c.reference_mse < times * reference.relative_mse * 1024 / samples);
}

}  // namespace

TEST_CASE("the Cornell box agrees with its reference") {
  if (const auto folder = referenceFolder())
    check(renderAndCompare(*folder, kCornell, 32), 0.003, kCornell, 32);
}

TEST_CASE("the knot in the box agrees with its reference") {
  if (const auto folder = referenceFolder())
    check(renderAndCompare(*folder, kKnot, 8), 0.006, kKnot, 8);
}

TEST_CASE("glass, a mirror and rough metal, and a sky agree with their references") {
  const auto folder = referenceFolder();
  if (!folder) return;
  const Reference reference = GENERATE(kGlass, kMirrorGloss, kSky);
  check(renderAndCompare(*folder, reference, 16), 0.01, reference, 16);
}

TEST_CASE("all scenes agree with their references at 1024 samples", "[long]") {
  const auto folder = referenceFolder();
  if (!folder) return;
  const Reference reference = GENERATE(kCornell, kKnot, kGlass, kMirrorGloss, kSky);
  const ReferenceComparison c = renderAndCompare(*folder, reference, 1024);
  check(c, 0.003, reference, 1024, 2);
  CHECK(std::abs(c.median_block_ratio - 1) < 0.002);
  CHECK(c.blocks_within_2_percent > 0.98);
}
