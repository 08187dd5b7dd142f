// The environments that are built in.
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <glm/vec3.hpp>
#include <iostream>

#include "renderer/scene/studio.h"
#include "renderer/scene/sun_sky.h"

using namespace glimt;

namespace {

constexpr double kPi = 3.14159265358979;

glm::dvec3 directionAt(const Image& image, int x, int y) {
  const double around = 2 * kPi * ((x + 0.5) / image.width - 0.5);
  const double down = kPi * (y + 0.5) / image.height;
  return {std::sin(down) * std::cos(around), std::cos(down), std::sin(down) * std::sin(around)};
}

// Of a white surface that faces `normal`.
glm::dvec3 radianceOfWhite(const Image& image, const glm::dvec3& normal) {
  glm::dvec3 sum(0);
  for (int y = 0; y < image.height; ++y)
    for (int x = 0; x < image.width; ++x) {
      const glm::dvec3 direction = directionAt(image, x, y);
      const double solid_angle = std::sin(kPi * (y + 0.5) / image.height) * 2 * kPi * kPi /
                                 (static_cast<double>(image.width) * image.height);
      const glm::dvec3 radiance(image.pixels[static_cast<std::size_t>(y * image.width + x)]);
      sum += radiance * (std::max(glm::dot(direction, normal), 0.0) * solid_angle);
    }
  return sum / kPi;
}

bool isSound(const Image& image) {
  return std::all_of(image.pixels.begin(), image.pixels.end(), [](const Vec3& p) {
    return std::min({p.r, p.g, p.b}) >= 0 && std::isfinite(p.r + p.g + p.b);
  });
}

}  // namespace

TEST_CASE("the studio lights what faces the front like a display's white, and all sides somewhat") {
  const Image studio = makeStudio();
  CHECK(isSound(studio));
  const double front = radianceOfWhite(studio, {0, 0, 1}).g;
  std::cout << "white in the studio: front " << front;
  CHECK(front > 0.5);
  CHECK(front < 1);
  for (const glm::dvec3& normal : {glm::dvec3(1, 0, 0), glm::dvec3(-1, 0, 0), glm::dvec3(0, 1, 0),
                                   glm::dvec3(0, 0, -1), glm::dvec3(0, -1, 0)}) {
    const double side = radianceOfWhite(studio, normal).g;
    std::cout << ", " << side;
    CHECK(side < 1.2);
    CHECK(side > 0.05);
  }
  std::cout << "\n";
}

TEST_CASE("the sun stands where it is said to stand, and nothing else is as bright") {
  const float elevation = GENERATE(5.0f, 45.0f, 80.0f);
  const Image sky = makeSunSky({elevation, 120, 3});
  const auto brightest = std::max_element(sky.pixels.begin(), sky.pixels.end(),
                                          [](const Vec3& a, const Vec3& b) { return a.g < b.g; });
  const int at = static_cast<int>(brightest - sky.pixels.begin());
  const glm::dvec3 sun = directionAt(sky, at % sky.width, at / sky.width);
  CHECK(std::asin(sun.y) * 180 / kPi == Approx(static_cast<double>(elevation)).margin(0.4));
  const double rotation = std::atan2(-sun.z, sun.x) * 180 / kPi;
  CHECK(rotation == Approx(120).margin(elevation > 70 ? 1.5 : 0.5));
}

TEST_CASE("a clear day has the illuminances of a clear day, and they fall towards evening") {
  // Radiance 1 of white is 100 klx.
  const double noon = 100 * radianceOfWhite(makeSunSky({60, 0, 3}), {0, 1, 0}).g;
  const double evening = 100 * radianceOfWhite(makeSunSky({5, 0, 3}), {0, 1, 0}).g;
  std::cout << "horizontal illuminance: " << noon << " klx at 60 degrees, " << evening
            << " klx at 5\n";
  CHECK(noon > 80);
  CHECK(noon < 125);
  CHECK(evening > 1);
  CHECK(evening < 20);
}

TEST_CASE("the sky is blue, the low sun's side red, and haze makes the sky less blue") {
  const Image clear = makeSunSky({45, 0, 2});
  const Image hazy = makeSunSky({45, 0, 8});
  const auto away = [](const Image& sky) {  // half way up, opposite to the sun
    return glm::dvec3(sky.pixels[static_cast<std::size_t>(sky.height / 4 * sky.width)]);
  };
  CHECK(away(clear).b > 1.5 * away(clear).r);
  CHECK(away(hazy).b / away(hazy).r < away(clear).b / away(clear).r);
  const glm::dvec3 facing = radianceOfWhite(makeSunSky({8, 0, 2}), {1, 0, 0});
  CHECK(facing.r > 1.3 * facing.b);
}

TEST_CASE("a sky is sound at every elevation and turbidity that can be asked for") {
  for (const float elevation : {0.0f, 1.0f, 90.0f})
    for (const float turbidity : {2.0f, 10.0f})
      CHECK(isSound(makeSunSky({elevation, 0, turbidity})));
}
