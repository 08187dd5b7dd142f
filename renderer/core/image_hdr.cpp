#include <stb_image_write.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <string>

#include "renderer/core/error.h"
#include "renderer/core/image_codecs.h"

namespace glimt {
namespace {

// The largest value that eight bits with the exponent 127 can hold.
constexpr float kLargestRgbe = 0x1.fep126f;

// Of a line of the header.
const std::string kDenoisedStart = std::string(kDenoisedKey) + "=";

// stb cuts the eight bits off; values that are rounded to them beforehand do not grow darker.
Vec3 roundedToRgbe(Vec3 value) {
  for (int c = 0; c < 3; ++c) value[c] = value[c] > 0 ? std::min(value[c], kLargestRgbe) : 0.0f;
  for (int pass = 0; pass < 2; ++pass) {
    int exponent = 0;
    std::frexp(std::max({value.x, value.y, value.z}), &exponent);
    const float step = std::ldexp(1.0f, std::max(exponent - 8, -126));
    for (int c = 0; c < 3; ++c) {
      value[c] = std::min(step * std::round(value[c] / step), kLargestRgbe);
    }
  }
  return value;
}

using Rgbe = std::array<unsigned char, 4>;

[[noreturn]] void bad(const std::string& what) {
  throw Error(ErrorKind::input, what + "; write the picture again");
}

Vec3 radianceOf(const Rgbe& pixel) {
  if (pixel[3] == 0) return Vec3(0);
  return Vec3(pixel[0], pixel[1], pixel[2]) * std::ldexp(1.0f, pixel[3] - 136);
}

// Reads the file front to back. stb_image can read it, too, but goes round forever where a run is
// cut short, and takes the runs from before 1991 for picture.
class Decoder {
 public:
  explicit Decoder(std::string_view bytes) : rest_(bytes) {}

  Image decode() {
    Image image = takeHeader();
    const int width = image.width;
    const int height = image.height;
    demandPlausibleSize(width, height, rest_.size(), 256);
    image.pixels.reserve(static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
    std::vector<Rgbe> row(static_cast<std::size_t>(width));
    for (int y = 0; y < height; ++y) {
      takeRow(row);
      for (const Rgbe& pixel : row) image.pixels.push_back(radianceOf(pixel));
    }
    return image;
  }

 private:
  // Rows outside of this have no runs by channel.
  static constexpr int kShortestRow = 8;
  static constexpr int kLongestRow = 32767;

  std::string_view takeLine() {
    const std::size_t end = rest_.find('\n');
    if (end == std::string_view::npos) bad("not a Radiance picture, or its header is cut short");
    std::string_view line = rest_.substr(0, end);
    rest_.remove_prefix(end + 1);
    if (line.ends_with('\r')) line.remove_suffix(1);
    return line;
  }

  // A picture without pixels yet.
  Image takeHeader() {
    if (!takeLine().starts_with("#?")) bad("not a Radiance picture");
    Image image;
    bool rgbe = false;
    for (std::string_view line = takeLine(); !line.empty(); line = takeLine()) {
      rgbe = rgbe || line == "FORMAT=32-bit_rle_rgbe";
      image.denoised = image.denoised || line.starts_with(kDenoisedStart);
    }
    if (!rgbe) bad("the Radiance picture is not of the format 32-bit_rle_rgbe");
    const std::string line(takeLine());
    if (std::sscanf(line.c_str(), "-Y %9d +X %9d", &image.height, &image.width) != 2) {
      bad("the Radiance picture's rows do not run from the top and the left");
    }
    return image;
  }

  unsigned char takeByte() {
    if (rest_.empty()) bad("the Radiance picture is cut short");
    const auto byte = static_cast<unsigned char>(rest_.front());
    rest_.remove_prefix(1);
    return byte;
  }

  void takeRow(std::vector<Rgbe>& row) {
    const int width = static_cast<int>(row.size());
    const bool by_channel = width >= kShortestRow && width <= kLongestRow &&
                            rest_.substr(0, 2) == "\x02\x02" && rest_.size() > 2 &&
                            static_cast<unsigned char>(rest_[2]) < 128;
    if (!by_channel) return takePlainRow(row);
    rest_.remove_prefix(2);
    const int high = takeByte();
    if (256 * high + takeByte() != width) bad("a row of the Radiance picture has another length");
    for (std::size_t channel = 0; channel < 4; ++channel) takeChannel(row, channel);
  }

  void takeChannel(std::vector<Rgbe>& row, std::size_t channel) {
    for (std::size_t x = 0; x < row.size();) {
      const unsigned char code = takeByte();
      const bool run = code > 128;
      const std::size_t count = run ? code - 128u : code;
      if (count == 0 || count > row.size() - x) bad("the Radiance picture has a bad run");
      unsigned char value = run ? takeByte() : 0;
      for (std::size_t i = 0; i < count; ++i) {
        if (!run) value = takeByte();
        row[x++][channel] = value;
      }
    }
  }

  // Pixel by pixel. A pixel (1, 1, 1, n), which no value rounds to, repeats the one before it n
  // times; several in a row are the bytes of one number, lowest first.
  void takePlainRow(std::vector<Rgbe>& row) {
    int shift = 0;
    for (std::size_t x = 0; x < row.size();) {
      Rgbe pixel{};
      for (unsigned char& value : pixel) value = takeByte();
      if (pixel[0] != 1 || pixel[1] != 1 || pixel[2] != 1) {
        row[x++] = pixel;
        shift = 0;
        continue;
      }
      const std::size_t count = std::size_t{pixel[3]} << shift;
      if (x == 0 || shift > 16 || count > row.size() - x) bad("the Radiance picture has a bad run");
      std::fill_n(row.begin() + static_cast<std::ptrdiff_t>(x), count, row[x - 1]);
      x += count;
      shift += 8;
    }
  }

  std::string_view rest_;
};

void append(void* bytes, void* data, int size) {
  static_cast<std::string*>(bytes)->append(static_cast<const char*>(data),
                                           static_cast<std::size_t>(size));
}

}  // namespace

Image decodeHdr(std::string_view bytes) {
  return Decoder(bytes).decode();
}

std::string encodeHdr(const Image& image) {
  std::vector<Vec3> pixels = image.pixels;
  for (Vec3& pixel : pixels) pixel = roundedToRgbe(pixel);
  std::string bytes;
  stbi_write_hdr_to_func(append, &bytes, image.width, image.height, 3, &pixels.data()->x);
  if (image.denoised) bytes.insert(bytes.find('\n') + 1, kDenoisedStart + kDenoisedText + '\n');
  return bytes;
}

}  // namespace glimt
