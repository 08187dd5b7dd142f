// The mean of very many samples: of the pass itself, fed with a known radiance, and of its
// arithmetic over a million samples.
#include <algorithm>
#include <array>
#include <catch2/catch.hpp>
#include <cmath>
#include <limits>

#include "renderer/gl/device.h"
#include "renderer/passes/accumulation.h"
#include "shaders/layout.h"
#include "tests/hard/hard_case.h"
#include "tests/shader/glsl_float.h"

using namespace glimt;
using namespace glimt::test;

namespace {

std::uint32_t hash(std::uint32_t x) {
  x = (x ^ (x >> 16)) * 0x7feb352du;
  x = (x ^ (x >> 15)) * 0x846ca68bu;
  return x ^ (x >> 16);
}

// What samples of a pixel are like: even, flickering, noisy, almost even, seldom lit.
constexpr int kPatterns = 5;
float patternAt(int pattern, std::uint32_t frame) {
  const float random = static_cast<float>(hash(frame) >> 8) * 0x1p-24f;
  switch (pattern) {
    case 0:
      return 0.1f;
    case 1:
      return frame % 2 == 0 ? 0.3f : 2.0f;
    case 2:
      return random;
    case 3:
      return 0.7f + 0.01f * random;
    default:
      return random < 0.001f ? 1000.0f : 0.01f;
  }
}

constexpr std::array kScales{1e-6f, 1.0f, 1e6f};  // one a channel

Vec3 radianceAt(int pattern, std::uint32_t frame) {
  const float value = patternAt(pattern, frame);
  return {value * kScales[0], value * kScales[1], value * kScales[2]};
}

// Relative, the largest of the channels; infinite where one is not a number.
double driftOf(const Vec4& mean, const glm::dvec3& expected) {
  double largest = 0;
  for (int c = 0; c < 3; ++c) {
    const double drift = std::abs(static_cast<double>(mean[c]) / expected[c] - 1);
    largest =
        std::isnan(drift) ? std::numeric_limits<double>::infinity() : std::max(largest, drift);
  }
  return largest;
}

// A row of pixels, one a pattern, through the passes. The frames come around again and again.
class Feed {
 public:
  Feed() : context_(hardContext()), device_(context_.get()), accumulation_(device_) {
    accumulation_.resize(kWidth, 1);
  }

  gl::Texture texture(std::vector<Vec4> texels) const {
    texels.resize(kWidth, Vec4(0));
    return gl::Texture::floats(device_.gl(), device_.floatForm(), kWidth, 1, texels);
  }

  void add(const gl::Texture& radiance) {
    const gl::Tile all{0, 0, kWidth, 1};
    accumulation_.add(radiance, all);
    accumulation_.endSample();
    if (++samples_ % SAMPLES_PER_BLOCK != 0) return;
    accumulation_.closeBlock(all);
    accumulation_.endBlock();
  }

  std::vector<Vec4> mean() const { return accumulation_.readMean(); }

 private:
  static constexpr int kWidth = 8;
  ContextHandle context_;
  gl::Device device_;
  Accumulation accumulation_;
  int samples_ = 0;
};

}  // namespace

TEST_CASE("the mean that the passes make of thousands of frames is theirs") {
  constexpr std::uint32_t kFrames = 251;  // prime, so that blocks begin everywhere in it
  const std::uint32_t rounds = slowDriver() ? 8 : 40;
  Feed feed;
  std::vector<gl::Texture> frames;
  std::array<glm::dvec3, kPatterns> expected{};
  for (std::uint32_t frame = 0; frame < kFrames; ++frame) {
    std::vector<Vec4> texels;
    for (int pattern = 0; pattern < kPatterns; ++pattern) {
      texels.emplace_back(radianceAt(pattern, frame), 0);
      expected[static_cast<std::size_t>(pattern)] +=
          glm::dvec3(radianceAt(pattern, frame)) / static_cast<double>(kFrames);
    }
    frames.push_back(feed.texture(texels));
  }
  for (std::uint32_t i = 0; i < rounds * kFrames; ++i) feed.add(frames[i % kFrames]);
  const std::vector<Vec4> mean = feed.mean();
  double drift = 0;
  for (std::size_t i = 0; i < kPatterns; ++i) {
    CHECK(mean[i].w == static_cast<float>(rounds * kFrames));
    drift = std::max(drift, driftOf(mean[i], expected[i]));
  }
  checkAtMost("accumulation", "mean of a known pattern, by the passes",
              "drift after thousands of frames, relative", drift, 1e-5);
}

TEST_CASE("the mean of a million samples has not drifted") {
  double drift = 0;
  for (int pattern = 0; pattern < kPatterns; ++pattern) {
    glm::dvec3 sum(0);
    Vec4 mean(0);
    Vec4 block(0);
    for (std::uint32_t frame = 0; frame < 1'000'000; ++frame) {
      const Vec3 radiance = radianceAt(pattern, frame);
      sum += glm::dvec3(radiance);
      block += glsl_float::sampleForBlock(radiance);
      if ((frame + 1) % SAMPLES_PER_BLOCK != 0) continue;
      mean = glsl_float::meanWithBlock(mean, block);
      block = Vec4(0);
    }
    drift = std::max(drift, driftOf(glsl_float::meanWithBlock(mean, block), sum / 1e6));
  }
  checkAtMost("accumulation", "mean of a known pattern, 1e-6 to 1e6",
              "drift after 1,000,000 samples, relative", drift, 1e-5);
}

TEST_CASE("a sample that is not finite poisons nothing and is counted") {
  const float infinity = std::numeric_limits<float>::infinity();
  const float nan = std::numeric_limits<float>::quiet_NaN();
  const int samples = 2 * SAMPLES_PER_BLOCK + 3;
  Feed feed;
  const std::vector<Vec4> good(7, Vec4(0.5f, 2, 3e5f, 0));
  std::vector<Vec4> bad = good;
  bad[1].r = nan;
  bad[2].g = infinity;
  bad[3].b = -infinity;
  bad[4] = Vec4(-1e30f);
  bad[5].r = std::numeric_limits<float>::max();
  bad[6] = Vec4(nan);
  const gl::Texture even = feed.texture(good);
  const gl::Texture odd = feed.texture(bad);
  for (int i = 0; i < samples; ++i) feed.add(i == 0 || i == 200 || i == samples - 1 ? odd : even);
  const std::vector<Vec4> mean = feed.mean();
  double drift = 0;
  int uncounted = 0;
  for (std::size_t i = 0; i < good.size(); ++i) {
    drift = std::max(drift, driftOf(mean[i], glm::dvec3(good[i])));
    uncounted += mean[i].w != static_cast<float>(i == 0 ? samples : samples - 3);
  }
  checkAtMost("accumulation", "three samples that are not finite",
              "error of the mean of the others, relative", drift, 1e-6);
  checkAtMost("accumulation", "three samples that are not finite",
              "pixels that miscount their samples", uncounted, 0);
}
