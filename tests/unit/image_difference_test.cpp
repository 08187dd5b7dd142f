#include "renderer/core/image_difference.h"

#include <catch2/catch.hpp>
#include <cmath>
#include <limits>

#include "tests/unit/expect_error.h"

using namespace glimt;

namespace {

Image image(int width, int height, std::vector<Vec3> pixels) {
  return {width, height, std::move(pixels)};
}

}  // namespace

TEST_CASE("a picture does not differ from itself") {
  const Image picture = image(2, 1, {Vec3(1, 2, 3), Vec3(0, 0.5f, 4)});
  const ImageDifference d = differenceOf(picture, picture);
  CHECK(d.mean_ratio == Vec3(1));
  CHECK(d.mse == 0);
  CHECK(d.relative_mse == 0);
  CHECK(std::isinf(d.psnr));
  CHECK(d.largest == 0);
  CHECK(d.noise == 0);
}

TEST_CASE("the difference of two known pictures is as computed by hand") {
  const Image reference = image(2, 1, {Vec3(1, 1, 1), Vec3(1, 1, 3)});
  const Image picture = image(2, 1, {Vec3(1.5f, 1, 1), Vec3(1, 1, 1)});
  const ImageDifference d = differenceOf(picture, reference);
  CHECK(d.mean_ratio.x == Approx(1.25));
  CHECK(d.mean_ratio.y == Approx(1));
  CHECK(d.mean_ratio.z == Approx(0.5));
  CHECK(d.mse == Approx((0.25 + 4.0) / 6));
  CHECK(d.relative_mse == Approx((0.25 / 1.01 + 4.0 / 9.01) / 6));
  CHECK(d.psnr == Approx(10 * std::log10(9.0 / d.mse)));
  CHECK(d.largest == Approx(2));
  // Of luminances 1 and 1.1444, that differ by 0.1063 and 0.1444.
  const double floor = (1 + 1.1444) / 8;
  CHECK(d.noise ==
        Approx(std::sqrt(0.5 * (std::pow(0.1063, 2) / (1 + floor * floor) +
                                std::pow(0.1444, 2) / (std::pow(1.1444, 2) + floor * floor)))));
}

TEST_CASE("black pictures are equal, and a black reference makes the ratio infinite") {
  const Image black = image(1, 1, {Vec3(0)});
  CHECK(differenceOf(black, black).mean_ratio == Vec3(1));
  CHECK(std::isinf(differenceOf(image(1, 1, {Vec3(1)}), black).mean_ratio.x));
}

TEST_CASE("pictures of different sizes cannot be compared, and the error names both sizes") {
  const std::string message = messageOf(ErrorKind::input, [] {
    differenceOf(image(2, 1, {Vec3(0), Vec3(0)}), image(1, 2, {Vec3(0), Vec3(0)}));
  });
  CHECK_THAT(message, Catch::Contains("2x1") && Catch::Contains("1x2"));
}

TEST_CASE("a value that is not finite is an error that says where it is") {
  const Image good = image(2, 2, std::vector<Vec3>(4, Vec3(1)));
  for (const float value : {std::numeric_limits<float>::infinity(), std::nanf("")}) {
    Image bad = good;
    bad.pixels[3].y = value;
    const auto in_picture = messageOf(ErrorKind::input, [&] { differenceOf(bad, good); });
    CHECK_THAT(in_picture, Catch::Contains("the picture") && Catch::Contains("column 1, row 1"));
    const auto in_reference = messageOf(ErrorKind::input, [&] { differenceOf(good, bad); });
    CHECK_THAT(in_reference, Catch::Contains("the reference"));
  }
}
