#include "renderer/core/image_difference.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "renderer/core/error.h"
#include "renderer/core/luminance.h"
#include "renderer/core/noise_estimate.h"

namespace glimt {
namespace {

void demandFinite(const Image& image, const char* which) {
  for (std::size_t i = 0; i < image.pixels.size(); ++i) {
    const Vec3& p = image.pixels[i];
    if (std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z)) continue;
    const std::size_t width = static_cast<std::size_t>(image.width);
    throw Error(ErrorKind::input,
                fmt::format("the {} has a value that is not finite at column {}, row {} from the "
                            "top; render it again",
                            which, i % width, i / width));
  }
}

// Where both are dark there is nothing to tell apart.
float ratio(double image, double reference) {
  return image == reference ? 1.0f : static_cast<float>(image / reference);
}

// See NoiseEstimate.
double noiseOf(const Image& image, const Image& reference) {
  const auto count = static_cast<double>(reference.pixels.size());
  double sum = 0;
  for (const Vec3& truth : reference.pixels) sum += luminance(truth);
  const double floor = kNoiseFloor * sum / count;
  double squares = 0;
  for (std::size_t i = 0; i < reference.pixels.size(); ++i) {
    const double truth = luminance(reference.pixels[i]);
    const double difference = luminance(image.pixels[i]) - truth;
    if (difference != 0) squares += difference * difference / (truth * truth + floor * floor);
  }
  return std::sqrt(squares / count);
}

}  // namespace

void demandSameSize(int width, int height, int reference_width, int reference_height) {
  if (width == reference_width && height == reference_height) return;
  throw Error(ErrorKind::input,
              fmt::format("the pictures are {}x{} and {}x{} pixels; only pictures of one size can "
                          "be compared",
                          width, height, reference_width, reference_height));
}

ImageDifference differenceOf(const Image& image, const Image& reference) {
  demandSameSize(image.width, image.height, reference.width, reference.height);
  demandFinite(image, "picture");
  demandFinite(reference, "reference");

  ImageDifference out;
  out.noise = noiseOf(image, reference);
  glm::dvec3 image_sum{0};
  glm::dvec3 reference_sum{0};
  double square_sum = 0;
  double relative_sum = 0;
  double peak = 0;
  for (std::size_t i = 0; i < reference.pixels.size(); ++i) {
    const glm::dvec3 value(image.pixels[i]);
    const glm::dvec3 truth(reference.pixels[i]);
    image_sum += value;
    reference_sum += truth;
    for (int c = 0; c < 3; ++c) {
      const double difference = value[c] - truth[c];
      square_sum += difference * difference;
      relative_sum += difference * difference / (truth[c] * truth[c] + 0.01);
      out.largest = std::max(out.largest, std::abs(difference));
      peak = std::max(peak, truth[c]);
    }
  }

  const double count = 3.0 * static_cast<double>(std::max<std::size_t>(1, reference.pixels.size()));
  for (int c = 0; c < 3; ++c) out.mean_ratio[c] = ratio(image_sum[c], reference_sum[c]);
  out.mse = square_sum / count;
  out.relative_mse = relative_sum / count;
  out.psnr = out.mse > 0 ? 10 * std::log10(peak * peak / out.mse)
                         : std::numeric_limits<double>::infinity();
  return out;
}

}  // namespace glimt
