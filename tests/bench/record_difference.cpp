// What packing the hit record does to a picture: the difference of two renders with the same seed,
// packed and wide, as cells of a table's row and as a picture.
// usage: record_difference PACKED.pfm WIDE.pfm DIFFERENCE.png
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <exception>
#include <glm/glm.hpp>

#include "renderer/core/image_file.h"

using namespace glimt;

namespace {

// Of the difference over the picture, in the wide picture's mean.
struct Means {
  glm::dvec3 difference{0};
  glm::dvec3 deviation{0};  // standard deviation of that mean, if pixels are independent
};

Means meansOf(const Image& packed, const Image& wide) {
  glm::dvec3 sum(0), squares(0), light(0);
  for (std::size_t i = 0; i < wide.pixels.size(); ++i) {
    const glm::dvec3 d = glm::dvec3(packed.pixels[i]) - glm::dvec3(wide.pixels[i]);
    sum += d;
    squares += d * d;
    light += glm::dvec3(wide.pixels[i]);
  }
  return {sum / light, glm::sqrt(squares) / light};
}

// One number a pixel: the mean of its channels.
class Plane {
 public:
  Plane(const Image& packed, const Image& wide) : width_(wide.width), height_(wide.height) {
    for (std::size_t i = 0; i < wide.pixels.size(); ++i)
      values_.push_back(
          glm::dot(glm::dvec3(packed.pixels[i]) - glm::dvec3(wide.pixels[i]), glm::dvec3(1.0 / 3)));
  }

  int width() const { return width_; }
  int height() const { return height_; }
  double at(int x, int y) const {
    return values_[static_cast<std::size_t>(y) * static_cast<std::size_t>(width_) +
                   static_cast<std::size_t>(x)];
  }

 private:
  int width_;
  int height_;
  std::vector<double> values_;
};

struct Correlation {
  double value = 0;       // in [-1, 1]
  double deviations = 0;  // from zero, in its standard deviations if pixels are independent
};

// Of pixels with their neighbours to the right and above. Pixels differ in their noise: the
// standard deviation is that of a sum of products of which each has its own size and a random sign.
Correlation neighbours(const Plane& plane) {
  double products = 0, squares_of_products = 0, squares = 0;
  const auto add = [&](double a, double b) {
    products += a * b;
    squares_of_products += a * a * b * b;
    squares += 0.5 * (a * a + b * b);
  };
  for (int y = 0; y + 1 < plane.height(); ++y)
    for (int x = 0; x + 1 < plane.width(); ++x) {
      add(plane.at(x, y), plane.at(x + 1, y));
      add(plane.at(x, y), plane.at(x, y + 1));
    }
  return {products / squares, products / std::sqrt(squares_of_products)};
}

struct Energy {
  double ratio = 0;      // of the blocks' sums, squared, to what independent pixels give: one
  double deviation = 0;  // standard deviation of that, if pixels are independent
};

Energy blockEnergy(const Plane& plane, int side) {
  double of_sums = 0, of_pixels = 0, spread = 0;
  for (int y = 0; y + side <= plane.height(); y += side)
    for (int x = 0; x + side <= plane.width(); x += side) {
      double sum = 0, squares = 0;
      for (int v = y; v < y + side; ++v)
        for (int u = x; u < x + side; ++u) {
          sum += plane.at(u, v);
          squares += plane.at(u, v) * plane.at(u, v);
        }
      of_sums += sum * sum;
      of_pixels += squares;
      spread += 2 * squares * squares;
    }
  return {of_sums / of_pixels, std::sqrt(spread) / of_pixels};
}

// Around mid-grey; black and white are four standard deviations away. Each pixel twice as large.
DisplayImage pictureOf(const Image& packed, const Image& wide, double* white) {
  double squares = 0;
  for (std::size_t i = 0; i < wide.pixels.size(); ++i) {
    const glm::dvec3 d = glm::dvec3(packed.pixels[i]) - glm::dvec3(wide.pixels[i]);
    squares += glm::dot(d, d) / 3;
  }
  *white = 4 * std::sqrt(squares / static_cast<double>(wide.pixels.size()));
  DisplayImage picture{2 * wide.width, 2 * wide.height, {}};
  for (int y = 0; y < picture.height; ++y)
    for (int x = 0; x < picture.width; ++x) {
      const auto i = static_cast<std::size_t>(y / 2 * wide.width + x / 2);
      for (int channel = 0; channel < 3; ++channel) {
        const double d = double(packed.pixels[i][channel]) - wide.pixels[i][channel];
        picture.bytes.push_back(
            static_cast<unsigned char>(std::clamp(127.5 + 127.5 * d / *white, 0.0, 255.0)));
      }
    }
  return picture;
}

double meanOf(const Image& image) {
  glm::dvec3 sum(0);
  for (const Vec3& pixel : image.pixels) sum += glm::dvec3(pixel);
  return glm::dot(sum, glm::dvec3(1.0 / 3)) / static_cast<double>(image.pixels.size());
}

void report(const Image& packed, const Image& wide, const char* file) {
  const Means means = meansOf(packed, wide);
  const Plane plane(packed, wide);
  const Correlation correlation = neighbours(plane);
  const Energy small = blockEnergy(plane, 8);
  const Energy large = blockEnergy(plane, 16);
  double white = 0;
  writeDisplayImage(file, pictureOf(packed, wide, &white));
  const glm::dvec3 percent = 100.0 * means.difference;
  fmt::print(
      "{:+.5f}, {:+.5f}, {:+.5f} | {:.5f} | {:+.4f} ({:+.1f}) | {:.2f} ± {:.2f} | {:.2f} ± {:.2f} "
      "| "
      "{:.2f}\n",
      percent.r, percent.g, percent.b,
      100 * std::max({means.deviation.r, means.deviation.g, means.deviation.b}), correlation.value,
      correlation.deviations, small.ratio, small.deviation, large.ratio, large.deviation,
      100 * white / meanOf(wide));
}

}  // namespace

int main(int count, char** words) {
  if (count != 4) {
    fmt::print(stderr, "usage: record_difference PACKED.pfm WIDE.pfm DIFFERENCE.png\n");
    return 2;
  }
  try {
    const Image packed = readImage(words[1]);
    const Image wide = readImage(words[2]);
    if (packed.width != wide.width || packed.height != wide.height) {
      fmt::print(stderr, "record_difference: the pictures differ in their sizes\n");
      return 3;
    }
    report(packed, wide, words[3]);
  } catch (const std::exception& error) {
    fmt::print(stderr, "record_difference: {}\n", error.what());
    return 1;
  }
}
