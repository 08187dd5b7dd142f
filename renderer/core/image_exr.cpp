#include <fmt/format.h>
#include <tinyexr.h>

#include <array>
#include <cstdlib>
#include <cstring>
#include <memory>
#include <string>

#include "renderer/core/error.h"
#include "renderer/core/image_codecs.h"
#include "renderer/core/image_layers.h"
#include "renderer/core/wording.h"

namespace glimt {
namespace {

constexpr std::size_t kPadding = 1 << 16;
constexpr long long kMostMemory = 1900LL << 20;

[[noreturn]] void bad(const std::string& what) {
  throw Error(ErrorKind::input,
              what + "; write the picture again, as one part in scan lines with R, G and B");
}

// tinyexr's message, which the caller has to free.
class Message {
 public:
  Message() = default;
  Message(const Message&) = delete;
  Message& operator=(const Message&) = delete;
  ~Message() { FreeEXRErrorMessage(text_); }

  const char** out() { return &text_; }
  std::string text() const { return text_ ? printable(text_) : "no reason given"; }

 private:
  const char* text_ = nullptr;
};

// Freed also when reading it fails midway: the public constructor begins once the private one is
// done.
class Header {
 public:
  explicit Header(std::string_view bytes) : Header() {
    const auto* data = reinterpret_cast<const unsigned char*>(bytes.data());
    EXRVersion version{};
    if (ParseEXRVersionFromMemory(&version, data, bytes.size()) != TINYEXR_SUCCESS) {
      bad("not an EXR picture");
    }
    if (version.multipart || version.non_image) bad("an EXR picture of several parts or of depth");
    // tinyexr ends the program when it meets damaged tiles.
    if (version.tiled) bad("an EXR picture in tiles");
    Message message;
    if (ParseEXRHeaderFromMemory(&header, &version, data, bytes.size(), message.out()) !=
        TINYEXR_SUCCESS) {
      bad(fmt::format("damaged EXR header ({})", message.text()));
    }
  }
  Header(const Header&) = delete;
  Header& operator=(const Header&) = delete;
  ~Header() { FreeEXRHeader(&header); }

  EXRHeader header;

 private:
  Header() { InitEXRHeader(&header); }
};

class Pixels {
 public:
  // Where reading fails midway, tinyexr has freed the image already: as many channels as it says.
  Pixels(std::string_view bytes, const EXRHeader& header) {
    InitEXRImage(&image);
    image.num_channels = header.num_channels;
    Message message;
    if (LoadEXRImageFromMemory(&image, &header,
                               reinterpret_cast<const unsigned char*>(bytes.data()), bytes.size(),
                               message.out()) != TINYEXR_SUCCESS) {
      bad(fmt::format("damaged EXR picture ({})", message.text()));
    }
  }
  Pixels(const Pixels&) = delete;
  Pixels& operator=(const Pixels&) = delete;
  ~Pixels() { FreeEXRImage(&image); }

  EXRImage image;
};

int channelNamed(const EXRHeader& header, const char* name) {
  for (int c = 0; c < header.num_channels; ++c) {
    if (std::strcmp(header.channels[c].name, name) == 0) return c;
  }
  return -1;
}

// Where R, G and B are; the same channel three times in a grey picture.
std::array<int, 3> colorChannels(const EXRHeader& header) {
  std::array<int, 3> channels = {channelNamed(header, "R"), channelNamed(header, "G"),
                                 channelNamed(header, "B")};
  const int luminance = channelNamed(header, "Y");
  const int grey = luminance >= 0 ? luminance : (header.num_channels == 1 ? 0 : -1);
  for (int& channel : channels) {
    if (channel < 0) channel = grey;
    if (channel < 0) bad("the EXR picture has no channels named R, G and B");
    if (header.pixel_types[channel] == TINYEXR_PIXELTYPE_UINT) {
      bad("the EXR picture's colours are integers");
    }
    if (header.channels[channel].x_sampling != 1 || header.channels[channel].y_sampling != 1) {
      bad("the EXR picture's colours are stored at a lower resolution");
    }
  }
  return channels;
}

bool hasAttribute(const EXRHeader& header, const char* name) {
  for (int i = 0; i < header.num_custom_attributes; ++i)
    if (std::strcmp(header.custom_attributes[i].name, name) == 0) return true;
  return false;
}

void copyPixels(const EXRImage& source, const std::array<int, 3>& channels, Image& image) {
  for (int c = 0; c < 3; ++c) {
    const int channel = channels[static_cast<std::size_t>(c)];
    const auto* values = reinterpret_cast<const float*>(source.images[channel]);
    for (std::size_t i = 0; i < image.pixels.size(); ++i) image.pixels[i][c] = values[i];
  }
}

int rowsPerBlock(int compression) {
  if (compression == TINYEXR_COMPRESSIONTYPE_PIZ) return 32;
  return compression == TINYEXR_COMPRESSIONTYPE_ZIP ? 16 : 1;
}

// tinyexr takes these numbers as they are, and allocates by them.
void demandPlausibleBlocks(const EXRHeader& header, long long width, long long height,
                           std::size_t bytes) {
  const int rows = rowsPerBlock(header.compression_type);
  const long long blocks = (height + rows - 1) / rows;
  if (header.chunk_count > 0 && header.chunk_count != blocks) {
    bad("the EXR picture has the wrong number of blocks");
  }
  // Each block has an offset, a position and a length.
  if (blocks > static_cast<long long>(bytes / 16)) bad("the EXR file ends too early");
  // The file twice, all channels as floats, and the picture.
  const long long memory =
      2 * static_cast<long long>(bytes) + width * height * (4LL * header.num_channels + 12);
  if (memory > kMostMemory) {
    bad("the EXR picture needs more than 2 GiB of memory to be read");
  }
}

}  // namespace

Image decodeExr(std::string_view bytes) {
  Header parsed(bytes);
  EXRHeader& header = parsed.header;
  const long long width = 1LL + header.data_window.max_x - header.data_window.min_x;
  const long long height = 1LL + header.data_window.max_y - header.data_window.min_y;
  // A block of at most 32 rows takes 16 bytes; in it, PIZ packs an even picture to nearly nothing.
  demandPlausibleSize(width, height, bytes.size(), 2.0 * static_cast<double>(width));
  demandPlausibleBlocks(header, width, height, bytes.size());
  const std::array<int, 3> channels = colorChannels(header);
  for (int c = 0; c < header.num_channels; ++c) {
    if (header.pixel_types[c] == TINYEXR_PIXELTYPE_HALF) {
      header.requested_pixel_types[c] = TINYEXR_PIXELTYPE_FLOAT;
    }
  }
  // tinyexr reads somewhat beyond the end of damaged blocks: let there be something to read.
  const std::string padded = std::string(bytes) + std::string(kPadding, '\0');
  const Pixels pixels(std::string_view(padded).substr(0, bytes.size()), header);

  Image image{static_cast<int>(width), static_cast<int>(height), {}};
  image.pixels.resize(static_cast<std::size_t>(width * height));
  if (pixels.image.width != width || pixels.image.height != height ||
      pixels.image.images == nullptr) {
    bad("damaged EXR picture");
  }
  copyPixels(pixels.image, channels, image);
  image.denoised = hasAttribute(header, kDenoisedKey);
  return image;
}

ImageLayers decodeLayers(std::string_view bytes) {
  Header parsed(bytes);
  EXRHeader& header = parsed.header;
  const long long width = 1LL + header.data_window.max_x - header.data_window.min_x;
  const long long height = 1LL + header.data_window.max_y - header.data_window.min_y;
  demandPlausibleSize(width, height, bytes.size(), 2.0 * static_cast<double>(width));
  demandPlausibleBlocks(header, width, height, bytes.size());
  for (int c = 0; c < header.num_channels; ++c) {
    if (header.pixel_types[c] == TINYEXR_PIXELTYPE_UINT || header.channels[c].x_sampling != 1 ||
        header.channels[c].y_sampling != 1)
      bad("the EXR picture has channels of integers, or at a lower resolution");
    header.requested_pixel_types[c] = TINYEXR_PIXELTYPE_FLOAT;
  }
  const std::string padded = std::string(bytes) + std::string(kPadding, '\0');
  const Pixels pixels(std::string_view(padded).substr(0, bytes.size()), header);
  if (pixels.image.width != width || pixels.image.height != height ||
      pixels.image.images == nullptr) {
    bad("damaged EXR picture");
  }
  ImageLayers layers{static_cast<int>(width), static_cast<int>(height), {}, {}};
  for (int c = 0; c < header.num_channels; ++c) {
    const auto* values = reinterpret_cast<const float*>(pixels.image.images[c]);
    layers.channels[header.channels[c].name].assign(values, values + width * height);
  }
  for (int i = 0; i < header.num_custom_attributes; ++i) {
    const EXRAttribute& attribute = header.custom_attributes[i];
    if (std::strcmp(attribute.type, "string") == 0 && attribute.size >= 0)
      layers.notes[attribute.name] = std::string(reinterpret_cast<const char*>(attribute.value),
                                                 static_cast<std::size_t>(attribute.size));
  }
  return layers;
}

}  // namespace glimt
