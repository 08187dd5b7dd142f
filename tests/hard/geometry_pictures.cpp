#include "tests/hard/geometry_pictures.h"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>

#include "tests/hard/hard_case.h"
#include "tests/image/pictures.h"

namespace glimt::test {

Image hardPicture(const Scene& scene, int size, int bounces, int samples) {
  return hardPicture(scene, size, size, bounces, samples);
}

Image hardPicture(const Scene& scene, int width, int height, int bounces, int samples) {
  RenderSettings settings = settingsFor(width, bounces);
  settings.height = height;
  ContextHandle context = hardContext();
  Renderer renderer(context, scene, settings);
  for (int i = 0; i < samples; ++i) renderer.renderSample();
  CHECK(renderer.nonfinitePixels() == 0);
  return renderer.radiance();
}

double brightnessOf(const Image& image) {
  const glm::dvec3 mean = meanOf(image);
  return (mean.r + mean.g + mean.b) / 3;
}

double meanDifference(const Image& image, const Image& expected) {
  return std::abs(brightnessOf(image) / brightnessOf(expected) - 1);
}

double worstBlockDifference(const Image& image, const Image& expected, int side) {
  double worst = 0;
  for (int y = 0; y + side <= image.height; y += side)
    for (int x = 0; x + side <= image.width; x += side) {
      glm::dvec3 difference(0);
      for (int v = y; v < y + side; ++v)
        for (int u = x; u < x + side; ++u) {
          const std::size_t i = static_cast<std::size_t>(v) * image.width + u;
          difference += glm::dvec3(image.pixels[i]) - glm::dvec3(expected.pixels[i]);
        }
      worst = std::max(worst, std::abs(difference.r + difference.g + difference.b) / 3);
    }
  return worst / (side * side) / brightnessOf(expected);
}

int pixelsThatDiffer(const Image& a, const Image& b) {
  int count = 0;
  for (std::size_t i = 0; i < a.pixels.size(); ++i) count += a.pixels[i] != b.pixels[i];
  return count;
}

int pixelsOtherThan(const Image& image, const Vec3& expected, double tolerance) {
  return static_cast<int>(
      std::count_if(image.pixels.begin(), image.pixels.end(), [&](const Vec3& pixel) {
        for (int channel = 0; channel < 3; ++channel) {
          const double off = std::abs(double{pixel[channel]} - double{expected[channel]});
          if (!(off <= tolerance * double{expected[channel]})) return true;
        }
        return false;
      }));
}

}  // namespace glimt::test
