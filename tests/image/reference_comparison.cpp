#include "tests/image/reference_comparison.h"

#include <algorithm>
#include <cmath>
#include <iostream>
#include <vector>

#include "renderer/core/image_file.h"

namespace glimt::test {
namespace {

constexpr int kGrow = 2;
constexpr int kBlock = 16;

class Mask {
 public:
  explicit Mask(const Image& reference)
      : reference_(reference), kept_(reference.pixels.size(), true) {}

  // With everything around it.
  void leaveOut(int x, int y) {
    for (int v = std::max(y - kGrow, 0); v <= std::min(y + kGrow, reference_.height - 1); ++v)
      for (int u = std::max(x - kGrow, 0); u <= std::min(x + kGrow, reference_.width - 1); ++u)
        kept_[at(u, v)] = false;
  }
  bool keeps(int x, int y) const { return kept_[at(x, y)]; }

 private:
  std::size_t at(int x, int y) const { return static_cast<std::size_t>(y) * reference_.width + x; }

  const Image& reference_;
  std::vector<bool> kept_;
};

const Vec3& pixel(const Image& image, int x, int y) {
  return image.pixels[static_cast<std::size_t>(y) * image.width + x];
}

float brightness(const Vec3& p) {
  return std::max({p.r, p.g, p.b});
}

bool isStep(const Vec3& a, const Vec3& b) {
  const float larger = std::max(brightness(a), brightness(b));
  return std::abs(brightness(a) - brightness(b)) > 0.25f * larger;
}

Mask maskOf(const Image& reference, float light_radiance) {
  Mask mask(reference);
  for (int y = 0; y < reference.height; ++y)
    for (int x = 0; x < reference.width; ++x) {
      const Vec3& here = pixel(reference, x, y);
      const bool light = brightness(here) > 0.25f * light_radiance;
      const bool step_x = x + 1 < reference.width && isStep(here, pixel(reference, x + 1, y));
      const bool step_y = y + 1 < reference.height && isStep(here, pixel(reference, x, y + 1));
      if (light || step_x || step_y) mask.leaveOut(x, y);
    }
  return mask;
}

double mean(const glm::dvec3& p) {
  return (p.r + p.g + p.b) / 3;
}

// Ratios of the blocks' means, sorted.
std::vector<double> blockRatios(const Image& image, const Image& reference, const Mask& mask,
                                double picture_mean) {
  std::vector<double> ratios;
  for (int y = 0; y < image.height; y += kBlock)
    for (int x = 0; x < image.width; x += kBlock) {
      glm::dvec3 sum(0);
      glm::dvec3 reference_sum(0);
      int count = 0;
      for (int v = y; v < std::min(y + kBlock, image.height); ++v)
        for (int u = x; u < std::min(x + kBlock, image.width); ++u) {
          if (!mask.keeps(u, v)) continue;
          sum += glm::dvec3(pixel(image, u, v));
          reference_sum += glm::dvec3(pixel(reference, u, v));
          ++count;
        }
      if (count > 0 && mean(reference_sum) / count > 0.05 * picture_mean)
        ratios.push_back(mean(sum) / mean(reference_sum));
    }
  std::sort(ratios.begin(), ratios.end());
  return ratios;
}

}  // namespace

std::optional<std::filesystem::path> referenceFolder() {
  const std::filesystem::path folder = std::filesystem::path(GLIMT_SHARED_DIR) / "reference";
  if (std::filesystem::exists(folder)) return folder;
  std::cout << "skipped: the reference pictures are not at " << folder << "\n";
  return std::nullopt;
}

ReferenceComparison compareWithReference(const Image& image, const std::filesystem::path& folder,
                                         const std::string& name, float light_radiance) {
  const Image reference = readImage(folder / (name + ".pfm"));
  const Image variance = readImage(folder / (name + ".var.pfm"));
  const Mask mask = maskOf(reference, light_radiance);
  ReferenceComparison result;
  glm::dvec3 sum(0);
  glm::dvec3 reference_sum(0);
  double count = 0;
  for (int y = 0; y < image.height; ++y)
    for (int x = 0; x < image.width; ++x) {
      if (!mask.keeps(x, y)) continue;
      const glm::dvec3 i(pixel(image, x, y));
      const glm::dvec3 r(pixel(reference, x, y));
      sum += i;
      reference_sum += r;
      result.relative_mse += mean((i - r) * (i - r) / (r * r + 0.01));
      result.reference_mse += mean(glm::dvec3(pixel(variance, x, y)) / (r * r + 0.01));
      ++count;
    }
  result.mean_ratio = sum / reference_sum;
  result.relative_mse /= count;
  result.reference_mse /= count;
  const auto ratios = blockRatios(image, reference, mask, mean(reference_sum) / count);
  result.median_block_ratio = ratios[ratios.size() / 2];
  result.blocks_within_2_percent =
      static_cast<double>(std::count_if(ratios.begin(), ratios.end(),
                                        [](double ratio) { return std::abs(ratio - 1) < 0.02; })) /
      static_cast<double>(ratios.size());
  return result;
}

}  // namespace glimt::test
