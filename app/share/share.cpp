#include "app/share/share.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>

#include "renderer/core/error.h"
#include "renderer/core/luminance.h"
#include "renderer/core/wording.h"

namespace glimt {
namespace {

constexpr const char* kRanges = "glimt.samples";
constexpr const char* kInputs = "glimt.inputs";
constexpr const char* kCount = "samples";
constexpr const char* kSpread = "spread";

[[noreturn]] void fail(const std::string& what) {
  throw Error(ErrorKind::input, what);
}

[[noreturn]] void failNoShare() {
  fail("no share of a picture; glimt render --samples FROM:COUNT makes one");
}

// "0:64,128:64".
std::string textOf(const std::vector<SampleRange>& ranges) {
  std::string text;
  for (const SampleRange& range : ranges)
    text += fmt::format("{}{}:{}", text.empty() ? "" : ",", range.first, range.count);
  return text;
}

std::vector<SampleRange> rangesIn(const std::string& text) {
  std::vector<SampleRange> ranges;
  const char* at = text.data();
  const char* const end = at + text.size();
  while (at != end) {
    SampleRange range;
    const auto first = std::from_chars(at, end, range.first);
    if (first.ec != std::errc() || first.ptr == end || *first.ptr != ':') failNoShare();
    const auto count = std::from_chars(first.ptr + 1, end, range.count);
    if (count.ec != std::errc() || range.first < 0 || range.count < 1) failNoShare();
    if (range.first > std::numeric_limits<int>::max() - range.count) failNoShare();
    at = count.ptr;
    if (at != end && (*at++ != ',' || at == end)) failNoShare();
    ranges.push_back(range);
  }
  if (ranges.empty()) failNoShare();
  return ranges;
}

std::vector<SampleRange> joined(std::vector<SampleRange> ranges,
                                const std::vector<SampleRange>& others) {
  ranges.insert(ranges.end(), others.begin(), others.end());
  std::sort(ranges.begin(), ranges.end(),
            [](const SampleRange& a, const SampleRange& b) { return a.first < b.first; });
  std::vector<SampleRange> out;
  for (const SampleRange& range : ranges) {
    if (!out.empty() && range.first < out.back().end())
      fail(fmt::format("has samples in common with another one, from {} on; a sample counts once",
                       range.first));
    if (!out.empty() && range.first == out.back().end())
      out.back().count += range.count;
    else
      out.push_back(range);
  }
  return out;
}

const std::vector<float>& channel(const ImageLayers& layers, const std::string& name) {
  const auto found = layers.channels.find(name);
  if (found == layers.channels.end()) failNoShare();
  return found->second;
}

const std::string& note(const ImageLayers& layers, const std::string& name) {
  const auto found = layers.notes.find(name);
  if (found == layers.notes.end()) failNoShare();
  return found->second;
}

}  // namespace

int samplesOf(const Share& share) {
  int samples = 0;
  for (const SampleRange& range : share.ranges) samples += range.count;
  return samples;
}

ImageLayers layersOf(const Share& share) {
  ImageLayers layers = layersOf(share.mean);
  layers.channels[kCount] = share.samples;
  layers.channels[kSpread] = share.spread;
  layers.notes[kRanges] = textOf(share.ranges);
  layers.notes[kInputs] = share.inputs;
  return layers;
}

Share shareOf(const ImageLayers& layers) {
  Share share;
  share.ranges = rangesIn(note(layers, kRanges));
  share.inputs = note(layers, kInputs);
  share.samples = channel(layers, kCount);
  share.spread = channel(layers, kSpread);
  share.mean = {layers.width, layers.height, {}};
  const auto& r = channel(layers, "R");
  const auto& g = channel(layers, "G");
  const auto& b = channel(layers, "B");
  for (std::size_t i = 0; i < r.size(); ++i) share.mean.pixels.emplace_back(r[i], g[i], b[i]);
  return share;
}

void ShareSum::add(const Share& share) {
  if (pixels_.empty()) {
    inputs_ = share.inputs;
    width_ = share.mean.width;
    height_ = share.mean.height;
    pixels_.resize(share.mean.pixels.size());
  }
  if (share.mean.width != width_ || share.mean.height != height_)
    fail(fmt::format("has {}x{} pixels, and the others {}x{}", share.mean.width, share.mean.height,
                     width_, height_));
  if (share.inputs != inputs_)
    fail("is of another picture: scene, camera, settings and glimt have to be the same");
  ranges_ = joined(ranges_, share.ranges);
  for (std::size_t i = 0; i < pixels_.size(); ++i) {
    Pixel& pixel = pixels_[i];
    const glm::dvec3 mean(share.mean.pixels[i]);
    const double samples = share.samples[i];
    const double spread = share.spread[i];
    const double all = pixel.samples + samples;
    if (!(all > 0)) continue;
    // Of two groups together: Chan, Golub and LeVeque 1979.
    const double between = luminance(share.mean.pixels[i]) - luminance(Vec3(pixel.mean));
    const double squares = pixel.samples * pixel.spread * pixel.spread + samples * spread * spread +
                           between * between * pixel.samples * samples / all;
    pixel.spread = std::sqrt(squares / all);
    pixel.mean = (pixel.samples * pixel.mean + samples * mean) / all;
    pixel.samples = all;
  }
}

Share ShareSum::share() const {
  Share share{ranges_, inputs_, {width_, height_, {}}, {}, {}};
  for (const Pixel& pixel : pixels_) {
    share.mean.pixels.emplace_back(pixel.mean);
    share.samples.push_back(static_cast<float>(pixel.samples));
    share.spread.push_back(static_cast<float>(pixel.spread));
  }
  return share;
}

double independentNoise(const Share& share) {
  const auto pixels = static_cast<double>(share.mean.pixels.size());
  double mean = 0;
  for (const Vec3& pixel : share.mean.pixels) mean += luminance(pixel) / pixels;
  const double floor = 0.25 * mean;
  double sum = 0;
  for (std::size_t i = 0; i < share.mean.pixels.size(); ++i) {
    const double own = luminance(share.mean.pixels[i]);
    const double spread = share.spread[i];
    const double yardstick = own * own + floor * floor;
    if (share.samples[i] > 0 && yardstick > 0)
      sum += spread * spread / static_cast<double>(share.samples[i]) / yardstick;
  }
  return std::sqrt(sum / pixels);
}

}  // namespace glimt
