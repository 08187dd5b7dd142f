// Which squares of a picture come to rest.
#include "renderer/passes/rest.h"

#include <catch2/catch.hpp>
#include <cmath>
#include <numeric>

#include "shaders/layout.h"

using namespace glimt;

namespace {

constexpr int kColumns = 12;
constexpr int kRows = 10;
constexpr int kWidth = kColumns * CHANGE_SQUARE - 3;  // the last squares stand over the edge
constexpr int kHeight = kRows * CHANGE_SQUARE - 5;

const std::vector<float> kEqualWork(static_cast<std::size_t>(kWidth) * kHeight, 4);

// The left half is calm, the right half 25 times as noisy.
std::vector<double> halves() {
  std::vector<double> noise;
  for (int i = 0; i < kColumns * kRows; ++i) noise.push_back(i % kColumns < kColumns / 2 ? 1 : 25);
  return noise;
}

double sumOf(const std::vector<double>& values) {
  return std::accumulate(values.begin(), values.end(), 0.0);
}

}  // namespace

TEST_CASE("calm squares rest before noisy ones, for the samples that are due") {
  Rest rest(kWidth, kHeight);
  // A tenth of the noise is wanted: 25 times the noise is due 5 times the samples.
  CHECK(rest.decide(halves(), kEqualWork, 64, 1, 0.1 * sumOf(halves())) == false);
  std::vector<double> later = halves();
  for (double& noise : later) noise *= 64.0 / 200;
  CHECK(rest.decide(later, kEqualWork, 200, 1, 0.1 * sumOf(halves())));
  CHECK(rest.samplesAt(0, 0) == 200);
  CHECK(rest.samplesAt(kWidth - 1, 0) == 0);
  double noise = 0;
  for (std::size_t i = 0; i < later.size(); ++i)
    if (rest.samplesOf(i) > 0) noise += later[i];
  CHECK(rest.noise() == Approx(noise));
  // The noise of neighbours counts, so the last calm column goes on.
  CHECK(rest.samplesAt((kColumns / 2 - 1) * CHANGE_SQUARE, 0) == 0);
}

TEST_CASE("squares do not all rest: the last have the goal to meet") {
  Rest rest(kWidth, kHeight);
  CHECK_FALSE(rest.decide(halves(), kEqualWork, 64, 1, sumOf(halves())));
  CHECK(rest.meanSamples(64) == 64);
  CHECK(rest.tiles().empty());
}

TEST_CASE("squares of little work get more samples than equally noisy ones of much") {
  std::vector<float> lengths = kEqualWork;
  for (std::size_t i = 0; i < lengths.size(); ++i)
    if (i % kWidth < kWidth / 2) lengths[i] = 0;
  const std::vector<double> even(static_cast<std::size_t>(kColumns) * kRows, 1);
  Rest rest(kWidth, kHeight);
  REQUIRE(rest.decide(even, lengths, 64, 1, 0.7 * sumOf(even)));
  CHECK(rest.samplesAt(0, 0) == 0);
  CHECK(rest.samplesAt(kWidth - 1, 0) == 64);
}

TEST_CASE("the rectangles at rest cover the pixels at rest, each once") {
  Rest rest(kWidth, kHeight);
  std::vector<double> noise;
  for (int i = 0; i < kColumns * kRows; ++i)
    noise.push_back(i % kColumns / 4 == 1 && i / kColumns > 2 ? 100 : 1);
  REQUIRE(rest.decide(noise, kEqualWork, 64, 1.2, 0.2 * sumOf(noise)));
  std::vector<int> covered(kEqualWork.size(), 0);
  for (const gl::Tile& tile : rest.tiles())
    for (int y = tile.y; y < tile.y + tile.height; ++y)
      for (int x = tile.x; x < tile.x + tile.width; ++x)
        ++covered.at(static_cast<std::size_t>(y) * kWidth + x);
  double samples = 0;
  bool equal = true;
  for (int y = 0; y < kHeight; ++y)
    for (int x = 0; x < kWidth; ++x) {
      const bool rests = rest.samplesAt(x, y) > 0;
      equal = equal && covered[static_cast<std::size_t>(y) * kWidth + x] == (rests ? 1 : 0);
      samples += rests ? 64 : 100;
    }
  CHECK(equal);
  CHECK(rest.meanSamples(100) == Approx(samples / (kWidth * kHeight)));
}
