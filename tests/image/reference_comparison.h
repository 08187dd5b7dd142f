// How a picture compares with a reference that another renderer made, as the README of the
// reference pictures says.
#pragma once

#include <filesystem>
#include <glm/vec3.hpp>
#include <optional>

#include "renderer/core/image.h"

namespace glimt::test {

struct ReferenceComparison {
  glm::dvec3 mean_ratio{0};            // over the kept pixels, per channel
  double relative_mse = 0;             // over the kept pixels
  double reference_mse = 0;            // what the reference's own noise contributes to it
  double median_block_ratio = 0;       // of 16 x 16 blocks brighter than 5% of the picture
  double blocks_within_2_percent = 0;  // share
};

// The reference pictures' folder, or nothing, and then a line on standard output says so.
std::optional<std::filesystem::path> referenceFolder();

// Left out are pixels that see a light of that brightest channel, and those around silhouettes.
ReferenceComparison compareWithReference(const Image& image, const std::filesystem::path& folder,
                                         const std::string& name, float light_radiance);

}  // namespace glimt::test
