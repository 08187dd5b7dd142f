#include "tests/hard/hard_picture.h"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>

#include "tests/hard/hard_case.h"
#include "tests/image/pictures.h"

namespace glimt::test {

Image hardPicture(const Scene& scene, const RenderSettings& settings, int samples) {
  ContextHandle context = hardContext();
  Renderer renderer(context, scene, settings);
  while (renderer.samples() < samples) renderer.renderSample();
  CHECK(renderer.nonfinitePixels() == 0);
  return renderer.radiance();
}

double meanRadiance(const Image& image) {
  const glm::dvec3 mean = meanOf(image);
  return (mean.r + mean.g + mean.b) / 3;
}

double brightest(const Image& image) {
  float largest = 0;
  for (const Vec3& pixel : image.pixels) largest = std::max({largest, pixel.r, pixel.g, pixel.b});
  return largest;
}

double relativeError(double measured, double expected) {
  return std::abs(measured / expected - 1);
}

void lookAtSpot(Scene& scene, const Vec3& eye, const Vec3& spot) {
  scene.camera.position = eye;
  scene.camera.target = spot;
  scene.camera.vertical_fov = 0.2f;
}

double polygonIrradiance(const std::vector<glm::dvec3>& polygon, const glm::dvec3& point,
                         const glm::dvec3& normal, double radiance) {
  double sum = 0;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const glm::dvec3 a = polygon[i] - point;
    const glm::dvec3 b = polygon[(i + 1) % polygon.size()] - point;
    const glm::dvec3 across = glm::cross(a, b);
    const double size = glm::length(across);
    if (size > 0) sum += std::atan2(size, glm::dot(a, b)) * glm::dot(across, normal) / size;
  }
  return 0.5 * radiance * std::abs(sum);
}

}  // namespace glimt::test
