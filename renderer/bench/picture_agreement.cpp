#include "renderer/bench/picture_agreement.h"

#include <cmath>

namespace glimt {
namespace {

constexpr double kDeviations = 5;
constexpr double kSystematic = 5e-4;  // of the mean

}  // namespace

PictureAgreement comparePictures(const std::vector<Vec4>& picture,
                                 const std::vector<Vec4>& reference, int samples) {
  const auto complete = [&](std::size_t i) {
    return picture[i].w == static_cast<float>(samples) &&
           reference[i].w == static_cast<float>(samples);
  };
  glm::dvec3 sum(0);
  glm::dvec3 difference(0);
  glm::dvec3 squares(0);
  std::size_t count = 0;
  for (std::size_t i = 0; i < picture.size(); ++i) {
    if (!complete(i)) continue;
    const glm::dvec3 here = glm::dvec3(picture[i]) - glm::dvec3(reference[i]);
    sum += glm::dvec3(reference[i]);
    difference += here;
    squares += here * here;
    ++count;
  }
  PictureAgreement result{count > 0, picture.size() - count};
  const auto n = static_cast<double>(count);
  for (int channel = 0; channel < 3 && result.agrees; ++channel) {
    const double mean = difference[channel] / n;
    const double deviation = std::sqrt(std::max(squares[channel] / n - mean * mean, 0.0) / n);
    const double bound = kDeviations * deviation + kSystematic * sum[channel] / n;
    result.agrees = std::abs(mean) <= bound;
  }
  return result;
}

}  // namespace glimt
