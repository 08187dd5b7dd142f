#include "renderer/core/image_file.h"

#include <cmath>
#include <cstring>
#include <limits>

#include "renderer/core/display_transform.h"
#include "renderer/core/image_codecs.h"
#include "renderer/core/image_layers.h"
#include "renderer/core/image_rgba.h"
#include "tests/unit/expect_error.h"
#include "tests/unit/temporary_folder.h"

using namespace glimt;
namespace fs = std::filesystem;

namespace {

// Values over many powers of two, different in each pixel and channel.
Image gradient(int width, int height) {
  Image image{width, height, {}};
  for (int i = 0; i < width * height; ++i) {
    const float t = static_cast<float>(i);
    image.pixels.emplace_back(std::exp2(0.1f * t - 8), 0.37f * t, 1.0f / (1.0f + t));
  }
  return image;
}

void checkSameValues(const Image& a, const Image& b) {
  REQUIRE(a.width == b.width);
  REQUIRE(a.height == b.height);
  REQUIRE(a.pixels.size() == b.pixels.size());
  for (std::size_t i = 0; i < a.pixels.size(); ++i) {
    CAPTURE(i);
    REQUIRE(std::memcmp(&a.pixels[i], &b.pixels[i], sizeof(Vec3)) == 0);
  }
}

std::string floats(const std::vector<float>& values, bool big_endian) {
  std::string bytes;
  for (const float value : values) {
    std::string four(4, '\0');
    std::memcpy(four.data(), &value, 4);
    bytes += big_endian ? std::string(four.rbegin(), four.rend()) : four;
  }
  return bytes;
}

std::string readError(const fs::path& path) {
  const std::string message = messageOf(ErrorKind::input, [&] { readImage(path); });
  CHECK_THAT(message, Catch::StartsWith(path.string() + ": "));
  return message;
}

}  // namespace

TEST_CASE("the extension decides the format, in upper or lower case") {
  CHECK(imageFormatOf("a.png") == ImageFormat::png);
  CHECK(imageFormatOf("a.b/c.EXR") == ImageFormat::exr);
  CHECK(imageFormatOf("a.Pfm") == ImageFormat::pfm);
  CHECK(imageFormatOf("a.hdr") == ImageFormat::hdr);
  for (const char* name : {"a.jpg", "png", "a.png.txt", ""}) {
    CHECK_THAT(messageOf(ErrorKind::usage, [&] { imageFormatOf(name); }),
               Catch::Contains("use .png, .exr, .pfm or .hdr"));
  }
}

TEST_CASE("radiance comes back from PFM and EXR bit by bit, whatever the size") {
  const TemporaryFolder folder;
  for (const char* name : {"image.pfm", "image.exr"}) {
    for (const auto& [width, height] : {std::pair{1, 1}, {3, 2}, {1, 40}, {70, 33}}) {
      CAPTURE(name, width, height);
      const Image image = gradient(width, height);
      writeImage(folder / name, image);
      checkSameValues(readImage(folder / name), image);
    }
  }
  CHECK(folder.fileCount() == 2);
}

TEST_CASE("PFM and EXR keep values that are not finite, so that they can be found") {
  const TemporaryFolder folder;
  Image image = gradient(4, 4);
  image.pixels[5] = Vec3(std::numeric_limits<float>::infinity(), -1, std::nanf(""));
  for (const char* name : {"image.pfm", "image.exr"}) {
    writeImage(folder / name, image);
    checkSameValues(readImage(folder / name), image);
  }
}

TEST_CASE("radiance comes back from HDR within half a step of eight bits, without a trend") {
  const TemporaryFolder folder;
  for (const int width : {3, 100}) {
    const Image image = gradient(width, 7);
    writeImage(folder / "image.hdr", image);
    const Image back = readImage(folder / "image.hdr");
    REQUIRE(back.width == width);
    REQUIRE(back.height == 7);
    double error_sum = 0;
    for (std::size_t i = 0; i < image.pixels.size(); ++i) {
      const Vec3& value = image.pixels[i];
      const float brightest = std::max({value.x, value.y, value.z});
      for (int c = 0; c < 3; ++c) {
        REQUIRE(std::abs(back.pixels[i][c] - value[c]) <= brightest * (1.01f / 256));
        error_sum += (back.pixels[i][c] - value[c]) / brightest;
      }
    }
    CHECK(std::abs(error_sum / (3.0 * static_cast<double>(image.pixels.size()))) < 6e-4);
  }
}

TEST_CASE("HDR has neither negative nor infinite values: they become zero and the largest") {
  const TemporaryFolder folder;
  const float infinity = std::numeric_limits<float>::infinity();
  writeImage(folder / "image.hdr", {3, 1, {Vec3(-1, 0, 1), Vec3(infinity), Vec3(std::nanf(""))}});
  const Image back = readImage(folder / "image.hdr");
  CHECK(back.pixels[0] == Vec3(0, 0, 1));
  CHECK(back.pixels[1].x > 1e38f);
  CHECK(std::isfinite(back.pixels[1].x));
  CHECK(back.pixels[2] == Vec3(0));
}

TEST_CASE("PFM is written from the bottom row, little-endian, as its header says") {
  const TemporaryFolder folder;
  writeImage(folder / "image.pfm", {1, 2, {Vec3(1, 2, 3), Vec3(4, 5, 6)}});
  CHECK(contentOf(folder / "image.pfm") == "PF\n1 2\n-1.0\n" + floats({4, 5, 6, 1, 2, 3}, false));
}

TEST_CASE("PFM is read in colour and grey, in either byte order") {
  const TemporaryFolder folder;
  const Image expected{1, 2, {Vec3(1, 2, 3), Vec3(4, 5, 6)}};
  const std::vector<float> values = {4, 5, 6, 1, 2, 3};
  checkSameValues(readImage(folder.write("a.pfm", "PF\n1 2\n1.0\n" + floats(values, true))),
                  expected);
  checkSameValues(readImage(folder.write("b.pfm", "PF 1 2 -3.5\n" + floats(values, false))),
                  expected);
  checkSameValues(readImage(folder.write("c.pfm", "Pf\n1 2\n-1\n" + floats({4, 1}, false))),
                  {1, 2, {Vec3(1), Vec3(4)}});
}

TEST_CASE("PFM headers that are wrong, or claim more than the file has, are errors") {
  const TemporaryFolder folder;
  const std::string pixel = floats({1, 2, 3}, false);
  for (const std::string& header :
       {std::string(), std::string("PF"), std::string("PX\n1 1\n-1\n"),
        std::string("PF\nx 1\n-1\n"), std::string("PF\n1 1\n0\n"), std::string("PF\n1 1\nnan\n"),
        std::string("PF\n1 2\n-1\n"), std::string("PF\n0 1\n-1\n"), std::string("PF\n-1 -1\n-1\n"),
        std::string("PF\n2000000000 2000000000\n-1\n"), std::string("PF\n99999999999 1\n-1\n"),
        std::string("PF\n10000 10000\n-1\n")}) {
    CAPTURE(header);
    readError(folder.write("bad.pfm", header + pixel));
  }
}

TEST_CASE("display values come back from PNG, decoded from sRGB") {
  const TemporaryFolder folder;
  writeDisplayImage(folder / "image.png", {2, 1, {0, 255, 188, 10, 11, 1}});
  const Image back = readImage(folder / "image.png");
  REQUIRE(back.width == 2);
  REQUIRE(back.height == 1);
  CHECK(back.pixels[0].x == 0);
  CHECK(back.pixels[0].y == 1);
  CHECK(back.pixels[0].z == Approx(0.50289).epsilon(1e-4));
  CHECK(back.pixels[1].x == Approx(10 / 255.0 / 12.92));
  CHECK(back.pixels[1].y == Approx(0.0033465).epsilon(1e-4));
}

TEST_CASE("radiance is not written as PNG, nor display values as radiance") {
  const TemporaryFolder folder;
  messageOf(ErrorKind::usage, [&] { writeImage(folder / "a.png", gradient(1, 1)); });
  messageOf(ErrorKind::usage, [&] { writeDisplayImage(folder / "a.exr", {1, 1, {0, 0, 0}}); });
  CHECK(folder.fileCount() == 0);
}

TEST_CASE("a picture that is missing, or is something else, is an error that says so") {
  const TemporaryFolder folder;
  for (const char* extension : {".png", ".exr", ".pfm", ".hdr"}) {
    CAPTURE(extension);
    const std::string name = std::string("image") + extension;
    CHECK_THAT(readError(folder / name), Catch::Contains("no such file"));
    readError(folder.write(name, ""));
    readError(folder.write(name, "no picture at all\n\n-Y 3 +X 3\n"));
    readError(folder.write(name, std::string(5000, '\0')));
  }
}

TEST_CASE("a picture cut short anywhere, or with bytes changed, ends in a picture or an Error") {
  const TemporaryFolder folder;
  writeDisplayImage(folder / "image.png", {40, 20, std::vector<std::uint8_t>(2400, 77)});
  for (const char* name : {"image.exr", "image.pfm", "image.hdr"}) {
    writeImage(folder / name, gradient(40, 20));
  }
  for (const char* name : {"image.png", "image.exr", "image.pfm", "image.hdr"}) {
    CAPTURE(name);
    const std::string bytes = contentOf(folder / name);
    const std::string damaged_name = std::string("damaged-") + name;
    const auto tryReading = [&](const std::string& damaged) {
      try {
        const Image image = readImage(folder.write(damaged_name, damaged));
        REQUIRE(image.pixels.size() == static_cast<std::size_t>(image.width * image.height));
      } catch (const Error& error) {
        REQUIRE(error.kind() == ErrorKind::input);
      }
    };
    for (std::size_t size = 0; size < bytes.size(); size += 1 + size / 20) {
      tryReading(bytes.substr(0, size));
    }
    for (std::size_t at = 0; at < bytes.size(); at += 1 + at / 100) {
      for (const char byte : {'\0', '\x7f', '\xff'}) {
        std::string damaged = bytes;
        damaged[at] = byte;
        tryReading(damaged);
      }
    }
  }
}

TEST_CASE("a header of a few bytes cannot ask for memory that its file could never fill") {
  const TemporaryFolder folder;
  CHECK_THAT(readError(folder.write("a.hdr",
                                    "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 16000 +X "
                                    "16000\n")),
             Catch::Contains("16000x16000"));
  writeImage(folder / "a.exr", gradient(2, 2));
  std::string bytes = contentOf(folder / "a.exr");
  const std::size_t window = bytes.find("dataWindow");
  REQUIRE(window != std::string::npos);
  const std::size_t max_x = window + std::strlen("dataWindow") + 1 + 6 + 4 + 8;
  for (const std::size_t at : {max_x, max_x + 4})
    bytes.replace(at, 4, std::string("\xff\xff\0\0", 4));
  CHECK_THAT(readError(folder.write("b.exr", bytes)), Catch::Contains("65536x65536"));
}

TEST_CASE("HDR rows are read plain, and with runs as before 1991") {
  const TemporaryFolder folder;
  const std::string header = "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 1 +X 4\n";
  const std::string half = "\x80\x80\x80\x80";
  const std::string one = "\x80\x80\x80\x81";
  const std::vector<Vec3> expected = {Vec3(1), Vec3(0.5f), Vec3(0.5f), Vec3(0.5f)};
  CHECK(readImage(folder.write("a.hdr", header + one + half + half + half)).pixels == expected);
  CHECK(readImage(folder.write("b.hdr", header + one + half + "\x01\x01\x01\x02")).pixels ==
        expected);
  readError(folder.write("c.hdr", header + one + half + "\x01\x01\x01\x03"));
  readError(folder.write("d.hdr", header + "\x01\x01\x01\x03" + half));
}

TEST_CASE("layers come back from EXR bit by bit, with what is noted of them") {
  ImageLayers layers{3, 2, {}, {}};
  layers.channels["R"] = {0, 1, 2, 3, 4, 5};
  layers.channels["depth.Z"] = {1e-30f, -1, 7, 1e30f, 0.1f, 2};
  layers.notes["glimt.samples"] = "0:64";
  const ImageLayers back = decodeLayers(encodeLayers(layers));
  CHECK(back.width == 3);
  CHECK(back.channels == layers.channels);
  CHECK(back.notes.at("glimt.samples") == "0:64");
}

TEST_CASE("an alpha is kept in EXR beside the radiance, and in PNG without it in the colour") {
  Image image{2, 1, {Vec3(0.25f), Vec3(0)}};
  image.alpha = {0.5f, 0};
  CHECK(decodeLayers(encodeExr(image)).channels.at("A") == image.alpha);
  const RgbaImage rgba = decodeRgba(encodePng(displayImage(image, 0)));
  const RgbaImage whole = decodeRgba(encodePng(displayImage(Image{1, 1, {Vec3(0.5f)}}, 0)));
  CHECK(rgba.bytes[0] == whole.bytes[0]);
  CHECK(rgba.bytes[3] == 128);
  CHECK(rgba.bytes[7] == 0);
}
