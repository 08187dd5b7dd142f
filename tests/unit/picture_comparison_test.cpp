// Pictures agree within their noise, and only then.
#include "renderer/bench/picture_comparison.h"

#include <catch2/catch.hpp>
#include <limits>
#include <random>

using namespace glimt;

namespace {

constexpr int kSamples = 8;
constexpr std::size_t kPixels = 1024;

class Noise {
 public:
  Noise(std::uint32_t seed, float size) : random_(seed), off_(-size, size) {}

  // Around a radiance of one.
  std::vector<Vec4> sample() {
    std::vector<Vec4> pixels(kPixels);
    for (Vec4& pixel : pixels)
      pixel = Vec4(1 + off_(random_), 1 + off_(random_), 1 + off_(random_), 0);
    return pixels;
  }

 private:
  std::mt19937 random_;
  std::uniform_real_distribution<float> off_;
};

// Of two pictures of that noise; `change` is called with each sample of the first.
template <class Change>
PictureComparison compare(std::uint32_t seed, float noise, const Change& change) {
  Noise first(seed, noise);
  Noise second(1000 + seed, noise);
  PictureComparison comparison;
  for (int i = 0; i < kSamples; ++i) {
    std::vector<Vec4> picture = first.sample();
    change(picture);
    comparison.add(picture, second.sample());
  }
  return comparison;
}

auto brighter(float red) {
  return [red](std::vector<Vec4>& picture) {
    for (Vec4& pixel : picture) pixel.r += red;
  };
}

}  // namespace

TEST_CASE("pictures whose pixels differ by noise agree") {
  for (std::uint32_t seed = 1; seed < 100; ++seed)
    CHECK(compare(seed, 0.5f, [](std::vector<Vec4>&) {}).agrees());
}

TEST_CASE("a picture that is brighter in one channel by more than the noise does not agree") {
  // The mean of 1024 * 8 differences has a deviation of 0.5 * sqrt(2 / 3 / 8192) = 0.0045.
  CHECK_FALSE(compare(1, 0.5f, brighter(0.05f)).agrees());
  CHECK_FALSE(compare(1, 0.01f, brighter(0.003f)).agrees());
}

TEST_CASE("a picture that is wrong in a few pixels only does not agree") {
  const auto wrong = [](std::vector<Vec4>& picture) {
    for (std::size_t i = 0; i < 10; ++i) picture[i] += Vec4(10, 10, 10, 0);
  };
  CHECK_FALSE(compare(1, 0.5f, wrong).agrees());
}

TEST_CASE("values that are not known or not finite are counted and not compared") {
  const auto lost = [](std::vector<Vec4>& picture) {
    picture[17] = Vec4(-1e30f, -1e30f, -1e30f, 0);
    picture[18].g = std::numeric_limits<float>::quiet_NaN();
  };
  const PictureComparison comparison = compare(1, 0.5f, lost);
  CHECK(comparison.agrees());
  CHECK(comparison.lost() == 2 * kSamples);
}

TEST_CASE("pictures of which nothing is known do not agree") {
  CHECK_FALSE(PictureComparison().agrees());
  const auto lost = [](std::vector<Vec4>& picture) {
    for (Vec4& pixel : picture) pixel = Vec4(-1e30f);
  };
  CHECK_FALSE(compare(1, 0.5f, lost).agrees());
}
