#include "renderer/bench/picture_comparison.h"

#include <algorithm>
#include <cmath>

namespace glimt {
namespace {

constexpr double kDeviations = 5;
constexpr double kSystematic = 5e-4;  // of the mean

// As in shaders/accumulate.glsl.
bool isGood(const Vec4& radiance) {
  return std::min({radiance.r, radiance.g, radiance.b}) >= 0 &&
         radiance.r + radiance.g + radiance.b <= 1e30f;
}

}  // namespace

void PictureComparison::add(const std::vector<Vec4>& picture, const std::vector<Vec4>& reference) {
  pixels_.resize(picture.size());
  for (std::size_t i = 0; i < picture.size(); ++i) {
    if (!isGood(picture[i]) || !isGood(reference[i])) {
      ++lost_;
      continue;
    }
    const glm::dvec3 difference = glm::dvec3(picture[i]) - glm::dvec3(reference[i]);
    Pixel& pixel = pixels_[i];
    ++pixel.samples;
    pixel.reference += glm::dvec3(reference[i]);
    pixel.difference += difference;
    pixel.squares += difference * difference;
  }
}

bool PictureComparison::agrees() const {
  glm::dvec3 mean(0);
  glm::dvec3 difference(0);
  glm::dvec3 variance(0);
  double count = 0;
  for (const Pixel& pixel : pixels_) {
    if (pixel.samples < 2) continue;
    const double n = pixel.samples;
    mean += pixel.reference / n;
    difference += pixel.difference / n;
    variance += (pixel.squares - pixel.difference * pixel.difference / n) / (n * (n - 1));
    ++count;
  }
  bool all = count > 0;
  for (int channel = 0; channel < 3; ++channel) {
    // Both sides are sums over the pixels.
    const double noise = std::sqrt(std::max(variance[channel], 0.0));
    const double bound = kDeviations * noise + kSystematic * mean[channel];
    all = all && std::abs(difference[channel]) <= bound;
  }
  return all;
}

}  // namespace glimt
