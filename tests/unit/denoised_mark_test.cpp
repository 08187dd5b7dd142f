// Files of denoised pictures say so.
#include <catch2/catch.hpp>

#include "renderer/core/image_codecs.h"
#include "renderer/core/image_layers.h"
#include "renderer/core/png_chunks.h"

using namespace glimt;

TEST_CASE("files of a denoised picture say so, and others do not") {
  Image image{9, 1, std::vector<Vec3>(9, Vec3(0.25f))};
  DisplayImage shown{2, 1, {0, 0, 0, 255, 255, 255}};
  for (const bool denoised : {false, true}) {
    CAPTURE(denoised);
    image.denoised = denoised;
    shown.denoised = denoised;
    CHECK(decodePng(encodePng(shown)).denoised == denoised);
    CHECK(decodeExr(encodeExr(image)).denoised == denoised);
    CHECK(decodeHdr(encodeHdr(image)).denoised == denoised);
    CHECK(decodeLayers(encodeExr(image)).notes.contains(kDenoisedKey) == denoised);
  }
}

TEST_CASE("a text in a PNG has the checksum that readers ask for, and the picture stays") {
  const std::string png = encodePng({2, 1, {0, 0, 0, 255, 255, 255}});
  const std::string with_text = withPngText(png, "Title", "glimt");
  // The checksum is that of zlib's crc32.
  CHECK(with_text.find(std::string("tEXtTitle\0glimt", 15) + "\x66\xe3\x0d\xd6") !=
        std::string::npos);
  CHECK(hasPngText(with_text, "Title"));
  CHECK_FALSE(hasPngText(with_text, "title"));
  CHECK_FALSE(hasPngText(png, "Title"));
  CHECK(decodePng(with_text).pixels == decodePng(png).pixels);
}
