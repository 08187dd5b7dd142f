// Shares of a picture's samples, in files and joined.
#include <catch2/catch.hpp>

#include <cmath>

#include "app/share/share.h"
#include "tests/unit/expect_error.h"

using namespace glimt;

namespace {

// One pixel's share: the mean and the standard deviation of its samples' luminance, which are grey.
Share shareOfSamples(int first, const std::vector<double>& samples) {
  double sum = 0;
  double squares = 0;
  for (const double sample : samples) {
    sum += sample;
    squares += sample * sample;
  }
  const auto count = static_cast<double>(samples.size());
  const double mean = sum / count;
  Share share{{{first, static_cast<int>(samples.size())}}, "inputs", {1, 1, {}}, {}, {}};
  share.mean.pixels.emplace_back(static_cast<float>(mean));
  share.samples.push_back(static_cast<float>(count));
  share.spread.push_back(static_cast<float>(std::sqrt(squares / count - mean * mean)));
  return share;
}

Share sumOf(const std::vector<Share>& shares) {
  ShareSum sum;
  for (const Share& share : shares) sum.add(share);
  return sum.share();
}

}  // namespace

TEST_CASE("joined shares have the mean, the number and the spread of all their samples") {
  const Share joined =
      sumOf({shareOfSamples(0, {1, 2, 5}), shareOfSamples(5, {7}), shareOfSamples(3, {0, 4})});
  const Share whole = shareOfSamples(0, {1, 2, 5, 0, 4, 7});
  CHECK(joined.mean.pixels[0].g == Approx(whole.mean.pixels[0].g));
  CHECK(joined.samples == whole.samples);
  CHECK(joined.spread[0] == Approx(whole.spread[0]));
  REQUIRE(joined.ranges.size() == 1);
  CHECK(joined.ranges[0].first == 0);
  CHECK(joined.ranges[0].count == 6);
}

TEST_CASE("a gap between shares stays one") {
  const Share joined = sumOf({shareOfSamples(10, {1, 2}), shareOfSamples(0, {3})});
  REQUIRE(joined.ranges.size() == 2);
  CHECK(joined.ranges[1].first == 10);
  CHECK(samplesOf(joined) == 3);
}

TEST_CASE("a sample counts once, and only those of one picture are joined") {
  const Share first = shareOfSamples(0, {1, 2, 3});
  CHECK_THAT(messageOf(ErrorKind::input,
                       [&] {
                         sumOf({first, shareOfSamples(2, {4})});
                       }),
             Catch::Contains("from 2 on"));
  Share other = shareOfSamples(3, {4});
  other.inputs = "others";
  CHECK_THAT(messageOf(ErrorKind::input,
                       [&] {
                         sumOf({first, other});
                       }),
             Catch::Contains("another picture"));
  Share larger = shareOfSamples(3, {4});
  larger.mean.width = 2;
  CHECK_THAT(messageOf(ErrorKind::input,
                       [&] {
                         sumOf({first, larger});
                       }),
             Catch::Contains("2x1 pixels, and the others 1x1"));
}

TEST_CASE("a pixel that has lost all its samples in one share has those of the others") {
  Share lost = shareOfSamples(0, {1});
  lost.samples[0] = 0;
  lost.mean.pixels[0] = Vec3(0);
  const Share joined = sumOf({lost, shareOfSamples(1, {3})});
  CHECK(joined.mean.pixels[0] == Vec3(3));
  CHECK(joined.samples[0] == 1);
}

TEST_CASE("a share comes back from its file as it was, to the last bit") {
  const Share share = sumOf({shareOfSamples(4, {0.1, 1e-7, 3e5}), shareOfSamples(16, {0.7})});
  const Share back = shareOf(decodeLayers(encodeLayers(layersOf(share))));
  CHECK(back.mean.pixels == share.mean.pixels);
  CHECK(back.samples == share.samples);
  CHECK(back.spread == share.spread);
  CHECK(back.inputs == share.inputs);
  REQUIRE(back.ranges.size() == 2);
  CHECK(back.ranges[1].first == 16);
}

TEST_CASE("what is no share, or says of its samples what cannot be, is an error") {
  ImageLayers layers = layersOf(shareOfSamples(0, {1, 2}));
  layers.notes["glimt.samples"] =
      GENERATE(as<std::string>{}, "", "x", "0:0", "-1:3", "0:2,", "0:2147483647,5", "2");
  CHECK_THAT(messageOf(ErrorKind::input, [&] { shareOf(layers); }),
             Catch::Contains("no share of a picture"));
  layers = layersOf(shareOfSamples(0, {1, 2}));
  layers.channels.erase("spread");
  messageOf(ErrorKind::input, [&] { shareOf(layers); });
  messageOf(ErrorKind::input, [&] { shareOf(layersOf(Image{1, 1, {Vec3(1)}})); });
}

TEST_CASE("the noise of independent samples is their spread over the root of their number") {
  const Share share = shareOfSamples(0, {1, 3, 1, 3});
  // Relative to the root of the mean's square and that of a quarter of it.
  CHECK(independentNoise(share) == Approx(0.5 / std::sqrt(4 + 0.25)));
}
