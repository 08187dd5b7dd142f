#include <fmt/format.h>
#include <tinyexr.h>

#include <array>
#include <cstdlib>
#include <cstring>
#include <memory>

#include "renderer/core/image_codecs.h"
#include "tests/hostile/good_files.h"
#include "tests/hostile/good_png.h"

namespace glimt {
namespace {

// Neither even nor square, and with runs for those that pack runs.
Image pattern(int width, int height) {
  Image image{width, height, {}};
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      const float run = static_cast<float>(x / 5 + 1);
      image.pixels.push_back(Vec3(run, 0.25f * run, x == y ? 1000.0f : 0.01f));
    }
  }
  return image;
}

struct ExrKind {
  const char* name;
  int compression;
  int stored_as;
  std::array<const char*, 3> channels;
};

std::string goodExr(int width, int height, const ExrKind& kind) {
  std::array<std::vector<float>, 3> planes;
  for (const Vec3& pixel : pattern(width, height).pixels) {
    for (int c = 0; c < 3; ++c) planes[static_cast<std::size_t>(c)].push_back(pixel[c]);
  }
  std::array<unsigned char*, 3> images{};
  std::array<EXRChannelInfo, 3> channels{};
  std::array<int, 3> given{};
  std::array<int, 3> stored{};
  for (std::size_t c = 0; c < 3; ++c) {
    images[c] = reinterpret_cast<unsigned char*>(planes[c].data());
    std::strncpy(channels[c].name, kind.channels[c], sizeof channels[c].name - 1);
    channels[c].x_sampling = channels[c].y_sampling = 1;
    given[c] = TINYEXR_PIXELTYPE_FLOAT;
    stored[c] = kind.stored_as;
  }
  EXRImage image;
  InitEXRImage(&image);
  image.num_channels = 3;
  image.images = images.data();
  image.width = width;
  image.height = height;
  EXRHeader header;
  InitEXRHeader(&header);
  header.num_channels = 3;
  header.channels = channels.data();
  header.pixel_types = given.data();
  header.requested_pixel_types = stored.data();
  header.compression_type = kind.compression;
  unsigned char* memory = nullptr;
  const char* message = nullptr;
  const std::size_t size = SaveEXRImageToMemory(&image, &header, &memory, &message);
  const std::unique_ptr<unsigned char, void (*)(void*)> owner(memory, std::free);
  return std::string(reinterpret_cast<const char*>(memory), size);
}

void addExrs(std::vector<GoodFile>& files) {
  constexpr std::array<const char*, 3> kColors = {"B", "G", "R"};
  constexpr ExrKind kKinds[] = {
      {"plain", TINYEXR_COMPRESSIONTYPE_NONE, TINYEXR_PIXELTYPE_FLOAT, kColors},
      {"rle", TINYEXR_COMPRESSIONTYPE_RLE, TINYEXR_PIXELTYPE_HALF, kColors},
      {"zips", TINYEXR_COMPRESSIONTYPE_ZIPS, TINYEXR_PIXELTYPE_HALF, kColors},
      {"zip", TINYEXR_COMPRESSIONTYPE_ZIP, TINYEXR_PIXELTYPE_FLOAT, kColors},
      {"piz-half", TINYEXR_COMPRESSIONTYPE_PIZ, TINYEXR_PIXELTYPE_HALF, kColors},
      {"piz", TINYEXR_COMPRESSIONTYPE_PIZ, TINYEXR_PIXELTYPE_FLOAT, kColors},
      {"grey", TINYEXR_COMPRESSIONTYPE_ZIP, TINYEXR_PIXELTYPE_HALF, {"A", "Y", "Z"}}};
  for (const ExrKind& kind : kKinds) {
    files.push_back({"exr", fmt::format("{}.exr", kind.name), goodExr(21, 34, kind)});
  }
}

void addPngs(std::vector<GoodFile>& files) {
  constexpr PngKind kKinds[] = {{8, 2, false}, {8, 0, true},   {1, 0, false}, {4, 3, false},
                                {16, 6, true}, {16, 2, false}, {8, 4, false}, {2, 3, true}};
  for (const PngKind& kind : kKinds) {
    files.push_back({"png",
                     fmt::format("{}-bit-type-{}{}.png", kind.bits, kind.color_type,
                                 kind.interlaced ? "-interlaced" : ""),
                     goodPng(13, 11, kind)});
  }
}

// As written before 1991: pixel (1, 1, 1, n) repeats the one before it n times.
std::string hdrOfPlainRows() {
  std::string bytes = "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 2 +X 6\n";
  for (int y = 0; y < 2; ++y) {
    bytes += "\x10\x20\x30\x81";
    bytes += "\x01\x01\x01\x04";
    bytes += "\x7f\x80\xff\x7f";
  }
  return bytes;
}

}  // namespace

std::vector<GoodFile> goodPictures() {
  std::vector<GoodFile> files = {
      {"pfm", "color.pfm", encodePfm(pattern(7, 5))},
      {"pfm", "grey-big-endian.pfm", std::string("Pf\n2 1\n1.0\n?\x80\0\0@\0\0\0", 20)},
      {"hdr", "runs.hdr", encodeHdr(pattern(21, 9))},
      {"hdr", "narrow.hdr", encodeHdr(pattern(5, 3))},
      {"hdr", "plain-rows.hdr", hdrOfPlainRows()},
  };
  addExrs(files);
  addPngs(files);
  return files;
}

}  // namespace glimt
