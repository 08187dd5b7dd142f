#include "tests/image/pictures.h"

#include <algorithm>
#include <cstring>
#include <limits>

namespace glimt::test {

RenderSettings settingsFor(int size, int bounces, std::uint32_t seed) {
  RenderSettings settings;
  settings.width = size;
  settings.height = size;
  settings.bounces = bounces;
  settings.seed = seed;
  return settings;
}

double middleOf(std::array<double, 3> values) {
  std::sort(values.begin(), values.end());
  return values[1];
}

Image render(const Scene& scene, const RenderSettings& settings, int samples, Backend backend) {
  ContextHandle context = createOffscreenContext(backend, 2);
  Renderer renderer(context, scene, settings);
  for (int i = 0; i < samples; ++i) renderer.renderSample();
  return renderer.radiance();
}

glm::dvec3 meanOf(const Image& image) {
  glm::dvec3 sum(0);
  for (const Vec3& pixel : image.pixels) sum += glm::dvec3(pixel);
  return sum / static_cast<double>(image.pixels.size());
}

bool identical(const Image& a, const Image& b) {
  return a.width == b.width && a.height == b.height &&
         std::memcmp(a.pixels.data(), b.pixels.data(), a.pixels.size() * sizeof(Vec3)) == 0;
}

double darkestBlock(const Image& image, int side) {
  double least = std::numeric_limits<double>::infinity();
  for (int y = 0; y + side <= image.height; y += side)
    for (int x = 0; x + side <= image.width; x += side) {
      Image block{side, side, {}};
      for (int v = y; v < y + side; ++v)
        for (int u = x; u < x + side; ++u)
          block.pixels.push_back(image.pixels[static_cast<std::size_t>(v) * image.width + u]);
      const glm::dvec3 mean = meanOf(block);
      least = std::min(least, (mean.r + mean.g + mean.b) / 3);
    }
  return least;
}

}  // namespace glimt::test
