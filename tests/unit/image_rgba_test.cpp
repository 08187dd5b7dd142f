// Pictures for surfaces.
#include <stb_image_write.h>

#include <catch2/catch.hpp>
#include <cstdlib>

#include "renderer/core/image_rgba.h"
#include "tests/hostile/good_png.h"
#include "tests/unit/expect_error.h"

using namespace glimt;

namespace {

void append(void* bytes, void* data, int size) {
  static_cast<std::string*>(bytes)->append(static_cast<const char*>(data),
                                           static_cast<std::size_t>(size));
}

std::string refusal(std::string_view bytes) {
  return messageOf(ErrorKind::input, [&] { decodeRgba(bytes); });
}

}  // namespace

TEST_CASE("a PNG keeps its values and its alpha") {
  const std::vector<std::uint8_t> values = {1, 2, 3, 4, 250, 251, 252, 253};
  std::string png;
  stbi_write_png_to_func(append, &png, 2, 1, 4, values.data(), 8);
  const RgbaImage image = decodeRgba(png);
  CHECK(image.width == 2);
  CHECK(image.height == 1);
  CHECK(image.bytes == values);
}

TEST_CASE("a JPEG has about its values, and is opaque") {
  const std::vector<std::uint8_t> values(8 * 8 * 3, 100);
  std::string jpeg;
  stbi_write_jpg_to_func(append, &jpeg, 8, 8, 3, values.data(), 95);
  const RgbaImage image = decodeRgba(jpeg);
  REQUIRE(image.bytes.size() == 256);
  // The quantisation step of the mean at that quality is 2 of 8 * 255.
  for (std::size_t c = 0; c < 3; ++c) CHECK(std::abs(image.bytes[c] - 100) <= 1);
  CHECK(image.bytes[3] == 255);
}

TEST_CASE("PNGs of every depth and kind become four bytes a pixel") {
  for (const PngKind kind : {PngKind{1, 0, false}, PngKind{8, 3, true}, PngKind{16, 2, false},
                             PngKind{16, 6, true}, PngKind{8, 4, false}}) {
    CAPTURE(kind.bits, kind.color_type);
    CHECK(decodeRgba(goodPng(7, 5, kind)).bytes.size() == 4 * 7 * 5);
  }
}

TEST_CASE("pictures that are none, are damaged or unpack without end are refused") {
  CHECK(refusal("").find("neither") != std::string::npos);
  CHECK(refusal("GIF89a and so on").find("neither") != std::string::npos);
  refusal(goodPng(7, 5, {8, 2, false}).substr(0, 50));
  refusal(explodingPng(1 << 24));
}
