#include "renderer/limit_error.h"

#include <algorithm>
#include <array>
#include <bit>
#include <chrono>
#include <cmath>
#include <vector>

#include "renderer/core/luminance.h"
#include "renderer/core/noise_estimate.h"

namespace glimt {
namespace {

// Of the small pictures: a part of the whole one's, and not more than needed.
constexpr double kPixelsShare = 1.0 / 16;
constexpr double kMostPixels = 64 * 64;

// Light is followed until more bounces add less than this share of it, or so many times.
constexpr double kHardlyAny = 5e-4;

// A pixel that differs from those around it by more standard deviations is not so by chance.
constexpr double kDeviations = 3;

constexpr int kLeastSamples = 2;
constexpr int kMostSamples = 64;

double now() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

using Luminances = std::vector<double>;

struct SmallPicture {
  int width = 0;
  int height = 0;

  std::size_t at(int x, int y) const { return static_cast<std::size_t>(y) * width + x; }
};

SmallPicture smallPictureOf(const RenderSettings& settings) {
  const double whole = static_cast<double>(settings.width) * settings.height;
  const double scale = std::sqrt(std::min(kPixelsShare, kMostPixels / whole));
  const auto side = [&](int pixels) {
    return std::max(static_cast<int>(std::lround(pixels * scale)), 1);
  };
  return {side(settings.width), side(settings.height)};
}

// From the picture's own limit on, further and further apart.
std::vector<int> limitsAbove(int bounces) {
  std::vector<int> limits{bounces};
  for (int step = 1; limits.back() < kMostBounces; step = limits.size() > 2 ? 2 * step : 1)
    limits.push_back(std::min(limits.back() + step, kMostBounces));
  return limits;
}

Luminances render(Renderer& renderer, const LightLimits& limits, int samples) {
  renderer.setLimits(limits);
  while (renderer.samples() < samples) renderer.renderSample();
  Luminances out;
  for (const Vec3& pixel : renderer.radiance().pixels) out.push_back(luminance(pixel));
  return out;
}

double meanOf(const Luminances& values) {
  double sum = 0;
  for (const double value : values) sum += value;
  return sum / static_cast<double>(values.size());
}

// One seed's pictures: without a clamp for each limit on bounces, and as the settings have it.
struct Pictures {
  std::vector<Luminances> of_limits;
  Luminances of_settings;
};

// What a pixel's error is relative to, squared, from two independent pictures. Their mean over
// three by three pixels has little of their noise, and is nevertheless wrong where a lamp shines
// beside the dark: there the pixel's own mean is taken, the more the further it is away from that
// of all nine, in terms of their noise.
double squareAt(const Luminances& first, const Luminances& second, const SmallPicture& size, int x,
                int y) {
  double sum = 0;
  double variance = 0;
  int count = 0;
  for (int j = std::max(y - 1, 0); j <= std::min(y + 1, size.height - 1); ++j) {
    for (int i = std::max(x - 1, 0); i <= std::min(x + 1, size.width - 1); ++i, ++count) {
      const std::size_t at = size.at(i, j);
      sum += 0.5 * (first[at] + second[at]);
      variance += 0.25 * (first[at] - second[at]) * (first[at] - second[at]);
    }
  }
  const double around = sum / count;
  const double own = 0.5 * (first[size.at(x, y)] + second[size.at(x, y)]);
  const double distance = (own - around) * (own - around);
  const double chance = kDeviations * kDeviations * variance / count;
  const double share = distance > 0 ? distance / (distance + chance) : 0;
  const double light = around + share * (own - around);
  return light * light;
}

Luminances scaleOf(const Luminances& first, const Luminances& second, const SmallPicture& size) {
  const double floor = kNoiseFloor * 0.5 * (meanOf(first) + meanOf(second));
  Luminances scale;
  for (int y = 0; y < size.height; ++y)
    for (int x = 0; x < size.width; ++x)
      scale.push_back(squareAt(first, second, size, x, y) + floor * floor);
  return scale;
}

// The error of pictures against others, of the same paths, from two independent pairs.
double errorOf(const std::array<const Luminances*, 2>& limited,
               const std::array<const Luminances*, 2>& whole, const Luminances& scale) {
  double sum = 0;
  for (std::size_t i = 0; i < scale.size(); ++i) {
    const double first = (*limited[0])[i] - (*whole[0])[i];
    const double second = (*limited[1])[i] - (*whole[1])[i];
    sum += first * second / scale[i];
  }
  return std::sqrt(std::max(sum, 0.0) / static_cast<double>(scale.size()));
}

class LimitMeter {
 public:
  LimitMeter(Renderer& renderer, const RenderSettings& settings)
      : renderer_(&renderer), settings_(settings), limits_(limitsAbove(settings.bounces)) {}

  LimitError measure(double noise, double seconds);

 private:
  double probe();
  Pictures render(std::uint32_t seed, int samples);
  int enoughBounces(const std::vector<double>& errors, double noise) const;

  Renderer* renderer_;
  const RenderSettings& settings_;
  std::vector<int> limits_;
};

// Leaves out the limits above which there is hardly any light. Returns the seconds that a sample of
// all the others takes.
double LimitMeter::probe() {
  const double start = now();
  double mean = 0;
  std::size_t used = 0;
  for (bool more = true; more && used < limits_.size(); ++used) {
    const double before = mean;
    mean = meanOf(glimt::render(*renderer_, {limits_[used], {}}, kLeastSamples));
    more = used < 2 || mean - before > kHardlyAny * mean;
  }
  limits_.resize(used);
  return (now() - start) / kLeastSamples;
}

Pictures LimitMeter::render(std::uint32_t seed, int samples) {
  renderer_->setSampler(settings_.sampler, seed);
  Pictures pictures;
  for (const int limit : limits_)
    pictures.of_limits.push_back(glimt::render(*renderer_, {limit, {}}, samples));
  pictures.of_settings =
      settings_.clamp ? glimt::render(*renderer_, {settings_.bounces, settings_.clamp}, samples)
                      : pictures.of_limits.front();
  return pictures;
}

// Between two limits the error is taken to fall by the same share with each bounce.
int LimitMeter::enoughBounces(const std::vector<double>& errors, double noise) const {
  std::size_t i = 0;
  while (errors[i] > noise) ++i;
  if (i == 0) return limits_.front();
  const int before = limits_[i - 1];
  if (!(errors[i] > 0) || !(noise > 0)) return limits_[i];
  const double part = std::log(errors[i - 1] / noise) / std::log(errors[i - 1] / errors[i]);
  return before + static_cast<int>(std::ceil(part * (limits_[i] - before)));
}

LimitError LimitMeter::measure(double noise, double seconds) {
  const SmallPicture size = smallPictureOf(settings_);
  renderer_->restBelow(std::nullopt);
  renderer_->resize(size.width, size.height);
  const double most = std::clamp(0.5 * seconds / probe(), 1.0 * kLeastSamples, 1.0 * kMostSamples);
  // A power of two, which is what low-discrepancy points do best.
  const int samples = static_cast<int>(std::bit_floor(static_cast<unsigned>(most)));
  const Pictures a = render(settings_.seed + 1, samples);
  const Pictures b = render(settings_.seed + 2, samples);
  const Luminances& all_a = a.of_limits.back();
  const Luminances& all_b = b.of_limits.back();
  const Luminances scale = scaleOf(all_a, all_b, size);
  std::vector<double> errors;
  for (std::size_t i = 0; i < limits_.size(); ++i)
    errors.push_back(errorOf({&a.of_limits[i], &b.of_limits[i]}, {&all_a, &all_b}, scale));
  LimitError out;
  out.truncation = errors.front();
  out.clamp = errorOf({&a.of_settings, &b.of_settings},
                      {&a.of_limits.front(), &b.of_limits.front()}, scale);
  out.both = errorOf({&a.of_settings, &b.of_settings}, {&all_a, &all_b}, scale);
  const double all = meanOf(all_a) + meanOf(all_b);
  if (all > 0) out.light = 1 - (meanOf(a.of_settings) + meanOf(b.of_settings)) / all;
  out.all_bounces = limits_.back();
  out.enough_bounces = enoughBounces(errors, noise);
  return out;
}

}  // namespace

LimitError measureLimits(Renderer& renderer, const RenderSettings& settings, double noise,
                         double seconds) {
  return LimitMeter(renderer, settings).measure(noise, seconds);
}

}  // namespace glimt
