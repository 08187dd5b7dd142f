// The points that pixels, dimensions and frames are sampled at look independent of each other.
// Within one set of dimensions the points of a pixel's frames are not meant to be: they avoid each
// other.
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <utility>

#include "renderer/gl/device.h"
#include "renderer/gl/program.h"
#include "renderer/gl/target.h"
#include "renderer/passes/sample_points.h"
#include "renderer/shader/composer.h"
#include "shaders/layout.h"
#include "tests/hard/hard_case.h"
#include "tests/hard/hard_picture.h"
#include "tests/image/pictures.h"
#include "tests/image/scenes.h"

using namespace glimt;
using namespace glimt::test;

namespace {

constexpr double kSigmas = 5;  // chance makes one of a million figures as large
constexpr int kSize = static_cast<int>(OFFSETS_SIZE);  // beyond it the offsets are repeated
constexpr int kPixels = kSize * kSize;
constexpr std::uint32_t kSets = 10;  // a path of four bounces
constexpr std::uint32_t kFrames = 4096;

using Numbers = std::vector<float>;  // one a pixel or a frame

double correlation(const Numbers& a, const Numbers& b) {
  const auto n = static_cast<double>(a.size());
  double mean_a = 0;
  double mean_b = 0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    mean_a += a[i] / n;
    mean_b += b[i] / n;
  }
  double aa = 0;
  double bb = 0;
  double ab = 0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    aa += (a[i] - mean_a) * (a[i] - mean_a);
    bb += (b[i] - mean_b) * (b[i] - mean_b);
    ab += (a[i] - mean_a) * (b[i] - mean_b);
  }
  return std::abs(ab) / std::sqrt(aa * bb);
}

// Of independent numbers.
double bound(double count) {
  return kSigmas / std::sqrt(count);
}

// The four numbers that every pixel gets from sample_points.glsl.
class PointPicture {
 public:
  explicit PointPicture(const gl::Device& device)
      : device_(&device),
        points_(1),
        offsets_(points_.makeOffsets(device)),
        program_(device.gl(), "points", composeVertexShader(),
                 composeProbe({"layout.h", "sample_points.glsl"},
                              "void main() { writeTexel(samplePoint(pixelCenter())); }\n")),
        target_(gl::Texture::floats(device.gl(), device.floatForm(), kSize, kSize)) {}

  // One list a dimension.
  std::vector<Numbers> draw(std::uint32_t sample, std::uint32_t set) {
    program_.use();
    program_.set("uZero", Vec4(0));
    points_.bindPoints(program_, "uPoint", sample, set);
    program_.set("uOffsetsShift", points_.offsetsShift(set));
    program_.set("uOffsets", offsets_);
    target_.bind();
    device_->draw({0, 0, kSize, kSize});
    std::vector<Numbers> dimensions(4);
    for (const Vec4& texel : target_.readFloats())
      for (int d = 0; d < 4; ++d) dimensions[static_cast<std::size_t>(d)].push_back(texel[d]);
    return dimensions;
  }

 private:
  const gl::Device* device_;
  SamplePoints points_;
  gl::Texture offsets_;
  gl::Program program_;
  gl::Target target_;
};

// The numbers of the pixels that lie that far from each pixel, around the edges.
Numbers moved(const Numbers& numbers, int width, int dx, int dy) {
  const int height = static_cast<int>(numbers.size()) / width;
  Numbers result(numbers.size());
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x)
      result[static_cast<std::size_t>(y * width + x)] = numbers[static_cast<std::size_t>(
          (y + dy + height) % height * width + (x + dx + width) % width)];
  return result;
}

constexpr std::array<std::pair<int, int>, 6> kNeighbours{
    {{1, 0}, {0, 1}, {1, 1}, {1, -1}, {2, 0}, {0, 2}}};

// The largest of all pairs of lists.
double worstPair(const std::vector<Numbers>& lists) {
  double worst = 0;
  for (std::size_t i = 0; i < lists.size(); ++i)
    for (std::size_t k = 0; k < i; ++k) worst = std::max(worst, correlation(lists[i], lists[k]));
  return worst;
}

}  // namespace

TEST_CASE("the points of neighbouring pixels, and of a path's dimensions, are not correlated") {
  ContextHandle context = hardContext();
  const gl::Device device(context.get());
  PointPicture picture(device);
  double neighbours = 0;
  std::vector<Numbers> path;
  for (std::uint32_t set = 0; set < kSets; ++set) {
    for (Numbers& numbers : picture.draw(17, set)) {
      for (const auto& [dx, dy] : kNeighbours)
        neighbours = std::max(neighbours, correlation(numbers, moved(numbers, kSize, dx, dy)));
      path.push_back(std::move(numbers));
    }
  }
  checkAtMost("random sequence", "points of neighbouring pixels", "largest correlation", neighbours,
              bound(kPixels));
  checkAtMost("random sequence", "40 dimensions of a path, over pixels", "largest correlation",
              worstPair(path), bound(kPixels));
}

// Points that avoid each other come in pairs, of which the second is opposite to the first in a
// coordinate's first bit. Products of two such coordinates are equal within a pair, which makes
// their mean vary more than that of independent numbers; likewise for the second bits of two pairs,
// and so on: by 1 + 144 / 240 in all.
double boundOfPairs(double count) {
  return bound(count) * std::sqrt(1.6);
}

// The largest correlation of dimensions of different sets, over frames lagged by 0 to 4.
double worstOverFrames(const SamplePoints& points, std::uint32_t group) {
  constexpr std::uint32_t kLags = 5;
  double worst = 0;
  for (std::uint32_t lag = 0; lag < kLags; ++lag) {
    std::vector<Numbers> ahead(4 * kSets);
    std::vector<Numbers> behind(4 * kSets);
    for (std::uint32_t frame = 0; frame < kFrames; ++frame)
      for (std::uint32_t set = 0; set < kSets; ++set)
        for (int d = 0; d < 4; ++d) {
          const std::size_t list = 4 * set + static_cast<std::size_t>(d);
          behind[list].push_back(points.point(frame, set, group)[d]);
          ahead[list].push_back(points.point(frame + lag, set, group)[d]);
        }
    for (std::size_t i = 0; i < ahead.size(); ++i)
      for (std::size_t k = 0; k < behind.size(); ++k)
        if (i / 4 != k / 4) worst = std::max(worst, correlation(ahead[i], behind[k]));
  }
  return worst;
}

TEST_CASE("the points of different dimensions are not correlated over frames, also lagged") {
  double worst = 0;
  for (std::uint32_t group = 0; group < POINT_GROUPS; ++group)
    worst = std::max(worst, worstOverFrames(SamplePoints(1), group));
  checkAtMost("random sequence", "40 dimensions of a path, over frames lagged by 0 to 4",
              "largest correlation", worst, boundOfPairs(kFrames));
}

TEST_CASE("the noise of neighbouring pixels is not correlated") {
  const int size = slowDriver() ? 64 : 256;
  // The same radiance is expected of every pixel, and all of the difference is noise.
  Scene scene = furnace(0.5f);
  double worst = 0;
  const Image image = hardPicture(scene, settingsFor(size, 1), 1);
  Numbers noise;
  // Bounded, so that a few bright pixels do not outweigh all others.
  for (const Vec3& pixel : image.pixels) noise.push_back(std::min(pixel.g, 4.0f));
  for (const auto& [dx, dy] : kNeighbours)
    worst = std::max(worst, correlation(noise, moved(noise, size, dx, dy)));
  checkAtMost("random sequence", "noise of neighbouring pixels", "largest correlation", worst,
              bound(static_cast<double>(size) * size));
}
