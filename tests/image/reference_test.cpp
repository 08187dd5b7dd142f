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

constexpr float kLight = 17;  // brightest channel of the boxes' light

ReferenceComparison renderAndCompare(const std::filesystem::path& folder, const std::string& name,
                                     int samples) {
  const Scene scene = loadScene(folder / (name + ".scene.json"));
  const Image image = render(scene, settingsFor(256, 4), samples);
  const ReferenceComparison c = compareWithReference(image, folder, name, kLight);
  std::cout << name << ", " << samples << " samples: mean ratio " << c.mean_ratio.r << " "
            << c.mean_ratio.g << " " << c.mean_ratio.b << ", relMSE " << c.relative_mse
            << " (of it the reference's " << c.reference_mse << "), median block "
            << c.median_block_ratio << ", blocks within 2% " << c.blocks_within_2_percent << "\n";
  return c;
}

// `relative_mse`: of a plain path tracer with pseudo-random numbers at this number of samples, from
// the README of the reference pictures.
void check(const ReferenceComparison& c, double mean_bound, double relative_mse) {
  for (int channel = 0; channel < 3; ++channel) {
    CHECK(c.mean_ratio[channel] > 1 - mean_bound);
    CHECK(c.mean_ratio[channel] < 1 + mean_bound);
  }
  CHECK(c.relative_mse - c.reference_mse < relative_mse);
}

}  // namespace

TEST_CASE("the Cornell box agrees with its reference") {
  if (const auto folder = referenceFolder())
    check(renderAndCompare(*folder, "cornell", 32), 0.003, 1.5e-4 * 1024 / 32);
}

TEST_CASE("the knot in the box agrees with its reference") {
  if (const auto folder = referenceFolder())
    check(renderAndCompare(*folder, "knot", 8), 0.006, 4.4e-4 * 1024 / 8);
}

TEST_CASE("the boxes agree with their references at 1024 samples", "[long]") {
  const auto folder = referenceFolder();
  if (!folder) return;
  const std::string name = GENERATE(std::string("cornell"), std::string("knot"));
  const ReferenceComparison c = renderAndCompare(*folder, name, 1024);
  check(c, 0.003, 2 * (name == "cornell" ? 1.5e-4 : 4.4e-4));
  CHECK(std::abs(c.median_block_ratio - 1) < 0.002);
  CHECK(c.blocks_within_2_percent > 0.98);
}
