// Pictures agree within their noise, and only then.
#include "renderer/bench/picture_agreement.h"

#include <catch2/catch.hpp>
#include <random>

using namespace glimt;

namespace {

constexpr int kSamples = 8;

// Around a radiance of one, each pixel off by up to `noise`, channel red by `red` on top of it.
std::vector<Vec4> picture(std::uint32_t seed, float noise, float red = 0) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<float> off(-noise, noise);
  std::vector<Vec4> pixels(4096);
  for (Vec4& pixel : pixels)
    pixel = Vec4(1 + off(random) + red, 1 + off(random), 1 + off(random), kSamples);
  return pixels;
}

}  // namespace

TEST_CASE("pictures whose pixels differ by noise agree") {
  for (std::uint32_t seed = 1; seed < 100; ++seed)
    CHECK(comparePictures(picture(seed, 0.5f), picture(1000 + seed, 0.5f), kSamples).agrees);
}

TEST_CASE("a picture that is brighter in one channel by more than the noise does not agree") {
  // The mean of 4096 differences has a deviation of 0.5 * sqrt(2 / 3 / 4096) = 0.0064.
  CHECK_FALSE(comparePictures(picture(1, 0.5f, 0.06f), picture(2, 0.5f), kSamples).agrees);
  CHECK_FALSE(comparePictures(picture(1, 0.01f, 0.003f), picture(2, 0.01f), kSamples).agrees);
}

TEST_CASE("pixels that lack a sample are counted and not compared") {
  std::vector<Vec4> lost = picture(1, 0.5f);
  lost[17] = Vec4(1e6f, 1e6f, 1e6f, kSamples - 1);
  const PictureAgreement agreement = comparePictures(lost, picture(2, 0.5f), kSamples);
  CHECK(agreement.agrees);
  CHECK(agreement.lost == 1);
}

TEST_CASE("pictures without any complete pixel, or with NaN, do not agree") {
  const std::vector<Vec4> sound = picture(1, 0.5f);
  CHECK_FALSE(comparePictures(sound, sound, kSamples + 1).agrees);
  std::vector<Vec4> broken = sound;
  broken[5].y = std::numeric_limits<float>::quiet_NaN();
  CHECK_FALSE(comparePictures(broken, sound, kSamples).agrees);
}
