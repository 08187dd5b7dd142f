// How different pictures look.
#include <catch2/catch.hpp>

#include "renderer/core/flip.h"

using namespace glimt;

namespace {

using Bytes = std::array<std::uint8_t, 3>;

constexpr Bytes kBlack{0, 0, 0};
constexpr Bytes kGray{128, 128, 128};
constexpr Bytes kWhite{255, 255, 255};

DisplayImage flat(int width, int height, const Bytes& color) {
  DisplayImage image{width, height, {}};
  for (int i = 0; i < width * height; ++i)
    image.bytes.insert(image.bytes.end(), color.begin(), color.end());
  return image;
}

// Black and white in turn, in squares.
DisplayImage checkered(int side, int square) {
  DisplayImage image{side, side, {}};
  for (int y = 0; y < side; ++y)
    for (int x = 0; x < side; ++x) {
      const Bytes color = (x / square + y / square) % 2 == 0 ? kBlack : kWhite;
      image.bytes.insert(image.bytes.end(), color.begin(), color.end());
    }
  return image;
}

double meanOf(const DisplayImage& a, const DisplayImage& b) {
  return flipOf(a, b).mean;
}

}  // namespace

TEST_CASE("equal pictures do not differ, and green from blue does as much as can be") {
  const DisplayImage picture = checkered(32, 5);
  CHECK(meanOf(picture, picture) == 0);
  CHECK(meanOf(flat(9, 5, {0, 255, 0}), flat(9, 5, {0, 0, 255})) == Approx(1).margin(1e-4));
}

TEST_CASE("what differs more looks more different, whichever of the pictures is which") {
  const DisplayImage gray = flat(8, 8, kGray);
  const DisplayImage near = flat(8, 8, {140, 140, 140});
  const DisplayImage far = flat(8, 8, {200, 200, 200});
  CHECK(meanOf(near, gray) > 0.01);
  CHECK(meanOf(far, gray) > 2 * meanOf(near, gray));
  CHECK(meanOf(far, gray) == Approx(meanOf(gray, far)));
  // By the paper's equations: lightness 100 against 0, to the power of 0.7.
  CHECK(meanOf(flat(8, 8, kWhite), flat(8, 8, kBlack)) == Approx(0.97).margin(0.02));
}

TEST_CASE("a pattern too fine for the eye differs less from its mean than a coarse one") {
  // Half of the light of white.
  const DisplayImage mean = flat(64, 64, {188, 188, 188});
  CHECK(meanOf(checkered(64, 1), mean) < 0.5 * meanOf(checkered(64, 16), mean));
}

TEST_CASE("what differs is where it differs") {
  DisplayImage spot = flat(64, 64, kGray);
  for (int i = 0; i < 3; ++i)
    for (int y = 40; y < 44; ++y)
      for (int x = 20; x < 24; ++x)
        spot.bytes[static_cast<std::size_t>((y * 64 + x) * 3 + i)] = 255;
  const FlipDifference difference = flipOf(spot, flat(64, 64, kGray));
  CHECK(difference.pixels[42 * 64 + 22] > 0.3f);
  CHECK(difference.pixels[10 * 64 + 50] == 0);
  const DisplayImage picture = flipPicture(difference, 64, 64);
  CHECK(picture.bytes.size() == spot.bytes.size());
  CHECK(picture.bytes[3 * (10 * 64 + 50)] == 0);
  CHECK(picture.bytes[3 * (42 * 64 + 22)] > 100);
}
