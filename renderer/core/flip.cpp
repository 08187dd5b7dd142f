#include "renderer/core/flip.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "renderer/core/image_difference.h"
#include "renderer/core/srgb.h"

namespace glimt {
namespace {

constexpr double kPi = std::numbers::pi;
constexpr double kPixelsPerDegree = 0.7 * 3840 / 0.7 * kPi / 180;

// Exponents and turning points of section 4 of the paper.
constexpr double kColorExponent = 0.7;
constexpr double kFeatureExponent = 0.5;
constexpr double kTurnAt = 0.4;
constexpr double kTurnTo = 0.95;
constexpr double kFeatureDegrees = 0.082;

// Each channel of a picture by itself.
using Plane = std::vector<float>;
using Color = glm::dvec3;

struct Planes {
  int width = 0;
  int height = 0;
  std::array<Plane, 3> channels;

  Color at(std::size_t i) const { return {channels[0][i], channels[1][i], channels[2][i]}; }
  void add(const Color& color) {
    for (int c = 0; c < 3; ++c)
      channels[static_cast<std::size_t>(c)].push_back(static_cast<float>(color[c]));
  }
};

// Relative to the white of D65, so that white is 1, 1, 1.
Color relativeXyzOf(const Color& rgb) {
  const Color x(0.4124564, 0.3575761, 0.1804375);
  const Color y(0.2126729, 0.7151522, 0.0721750);
  const Color z(0.0193339, 0.1191920, 0.9503041);
  const auto share = [&](const Color& row) { return glm::dot(row, rgb) / (row.x + row.y + row.z); };
  return {share(x), share(y), share(z)};
}

Color rgbOf(const Color& relative_xyz) {
  const Color xyz = relative_xyz * Color(0.9504700, 1.0000001, 1.0888300);
  return {glm::dot(Color(3.2404542, -1.5371385, -0.4985314), xyz),
          glm::dot(Color(-0.9692660, 1.8760108, 0.0415560), xyz),
          glm::dot(Color(0.0556434, -0.2040259, 1.0572252), xyz)};
}

// Lightness, red against green and blue against yellow, linear in radiance: what is blurred.
Color opponentOf(const Color& rgb) {
  const Color xyz = relativeXyzOf(rgb);
  return {116 * xyz.y - 16, 500 * (xyz.x - xyz.y), 200 * (xyz.y - xyz.z)};
}

Color rgbOfOpponent(const Color& opponent) {
  const double y = (opponent.x + 16) / 116;
  return glm::clamp(rgbOf({y + opponent.y / 500, y, y - opponent.z / 200}), 0.0, 1.0);
}

// L*a*b*, with less colour in the dark, after Hunt.
Color huntLabOf(const Color& rgb) {
  const auto f = [](double t) {
    constexpr double kDelta = 6.0 / 29;
    return t > kDelta * kDelta * kDelta ? std::cbrt(t) : t / (3 * kDelta * kDelta) + 4.0 / 29;
  };
  const Color xyz = relativeXyzOf(rgb);
  const double lightness = 116 * f(xyz.y) - 16;
  return {lightness, 0.01 * lightness * 500 * (f(xyz.x) - f(xyz.y)),
          0.01 * lightness * 200 * (f(xyz.y) - f(xyz.z))};
}

// The distance HyAB of Abasi et al. 2020.
double distance(const Color& a, const Color& b) {
  return std::abs(a.x - b.x) + std::hypot(a.y - b.y, a.z - b.z);
}

// A blur or a derivative along one axis, from its middle's left to its right.
using Kernel = std::vector<double>;

Plane filtered(const Plane& plane, int width, int height, const Kernel& kernel, bool down) {
  const int radius = static_cast<int>(kernel.size()) / 2;
  Plane out;
  out.reserve(plane.size());
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      double sum = 0;
      for (int k = -radius; k <= radius; ++k) {
        const int column = down ? x : std::clamp(x + k, 0, width - 1);
        const int row = down ? std::clamp(y + k, 0, height - 1) : y;
        sum += kernel[static_cast<std::size_t>(k + radius)] *
               plane[static_cast<std::size_t>(row) * width + column];
      }
      out.push_back(static_cast<float>(sum));
    }
  }
  return out;
}

Plane filtered(const Plane& plane, const Planes& size, const Kernel& across, const Kernel& down) {
  return filtered(filtered(plane, size.width, size.height, across, false), size.width, size.height,
                  down, true);
}

template <typename Function>
Kernel kernelOf(int radius, const Function& value) {
  Kernel kernel;
  for (int k = -radius; k <= radius; ++k) kernel.push_back(value(static_cast<double>(k)));
  return kernel;
}

// One term of how sensitive the eye is to a channel: a sqrt(pi / b) exp(-pi^2 x^2 / b), x in
// degrees; over the plane the product of it in x and in y.
struct Sensitivity {
  double a;
  double b;
};
constexpr std::array<std::array<Sensitivity, 2>, 3> kSensitivities{
    {{{{1, 0.0047}, {0, 1e-5}}}, {{{1, 0.0053}, {0, 1e-5}}}, {{{34.1, 0.04}, {13.5, 0.025}}}}};

void blurAsSeen(Planes& planes) {
  constexpr double kWidest = 0.04;
  const int radius =
      static_cast<int>(std::ceil(3 * std::sqrt(kWidest / (2 * kPi * kPi)) * kPixelsPerDegree));
  for (std::size_t c = 0; c < 3; ++c) {
    Plane sum(planes.channels[c].size(), 0.0f);
    double total = 0;
    for (const Sensitivity& term : kSensitivities[c]) {
      if (term.a == 0) continue;
      const Kernel kernel = kernelOf(radius, [&](double k) {
        const double x = k / kPixelsPerDegree;
        return std::exp(-kPi * kPi * x * x / term.b);
      });
      double mass = 0;
      for (const double value : kernel) mass += value;
      const double weight = term.a * std::sqrt(kPi / term.b);
      total += weight * mass * mass;
      const Plane part = filtered(planes.channels[c], planes, kernel, kernel);
      for (std::size_t i = 0; i < sum.size(); ++i) sum[i] += static_cast<float>(weight * part[i]);
    }
    for (float& value : sum) value = static_cast<float>(value / total);
    planes.channels[c] = std::move(sum);
  }
}

Planes opponentPlanes(const DisplayImage& image) {
  Planes planes{image.width, image.height, {}};
  for (std::size_t i = 0; i + 2 < image.bytes.size(); i += 3)
    planes.add(opponentOf({linearOfSrgb(image.bytes[i]), linearOfSrgb(image.bytes[i + 1]),
                           linearOfSrgb(image.bytes[i + 2])}));
  return planes;
}

// Makes the positive values sum to 1 and the negative ones to -1, which over the plane is so too
// where the kernel across is a blur.
void balance(Kernel& kernel) {
  double positive = 0;
  double negative = 0;
  for (const double value : kernel) (value > 0 ? positive : negative) += std::abs(value);
  for (double& value : kernel) value /= value > 0 ? positive : negative;
}

// How strong edges, or points, are in the lightness.
Plane featuresOf(const Planes& planes, bool points) {
  const double deviation = 0.5 * kFeatureDegrees * kPixelsPerDegree;
  const int radius = static_cast<int>(std::ceil(3 * deviation));
  const auto gaussian = [&](double k) { return std::exp(-k * k / (2 * deviation * deviation)); };
  Kernel blur = kernelOf(radius, gaussian);
  double mass = 0;
  for (const double value : blur) mass += value;
  for (double& value : blur) value /= mass;
  Kernel derivative = kernelOf(radius, [&](double k) {
    return (points ? k * k / (deviation * deviation) - 1 : -k) * gaussian(k);
  });
  balance(derivative);
  Plane lightness;
  for (const float value : planes.channels[0]) lightness.push_back((value + 16) / 116);
  Plane across = filtered(lightness, planes, derivative, blur);
  const Plane down = filtered(lightness, planes, blur, derivative);
  for (std::size_t i = 0; i < across.size(); ++i) across[i] = std::hypot(across[i], down[i]);
  return across;
}

// From distances of colours to 0 to 1; large ones, of which people only see that they are large,
// are pressed together.
double colorErrorOf(double hyab) {
  static const double most =
      std::pow(distance(huntLabOf({0, 1, 0}), huntLabOf({0, 0, 1})), kColorExponent);
  const double error = std::pow(hyab, kColorExponent);
  const double turn = kTurnAt * most;
  if (error < turn) return kTurnTo / turn * error;
  return kTurnTo + (error - turn) / (most - turn) * (1 - kTurnTo);
}

}  // namespace

FlipDifference flipOf(const DisplayImage& image, const DisplayImage& reference) {
  demandSameSize(image.width, image.height, reference.width, reference.height);
  Planes a = opponentPlanes(image);
  Planes b = opponentPlanes(reference);
  const std::array<Plane, 2> edges{featuresOf(a, false), featuresOf(b, false)};
  const std::array<Plane, 2> points{featuresOf(a, true), featuresOf(b, true)};
  blurAsSeen(a);
  blurAsSeen(b);
  FlipDifference out;
  double sum = 0;
  for (std::size_t i = 0; i < edges[0].size(); ++i) {
    const double color = colorErrorOf(
        distance(huntLabOf(rgbOfOpponent(a.at(i))), huntLabOf(rgbOfOpponent(b.at(i)))));
    const double edge = std::abs(edges[0][i] - edges[1][i]);
    const double point = std::abs(points[0][i] - points[1][i]);
    const double feature = std::pow(std::max(edge, point) / std::numbers::sqrt2, kFeatureExponent);
    const double error = std::clamp(std::pow(color, 1 - std::min(feature, 1.0)), 0.0, 1.0);
    out.pixels.push_back(static_cast<float>(error));
    sum += error;
  }
  if (!out.pixels.empty()) out.mean = sum / static_cast<double>(out.pixels.size());
  return out;
}

DisplayImage flipPicture(const FlipDifference& difference, int width, int height) {
  // Matplotlib's magma at equal steps.
  constexpr std::array<std::array<double, 3>, 6> kColors{
      {{0, 0, 4}, {59, 15, 112}, {140, 41, 129}, {222, 73, 104}, {254, 159, 109}, {252, 253, 191}}};
  DisplayImage picture{width, height, {}};
  for (const float value : difference.pixels) {
    const double at = 5 * std::clamp(static_cast<double>(value), 0.0, 1.0);
    const auto step = std::min<std::size_t>(static_cast<std::size_t>(at), 4);
    for (std::size_t c = 0; c < 3; ++c)
      picture.bytes.push_back(static_cast<std::uint8_t>(
          std::lerp(kColors[step][c], kColors[step + 1][c], at - static_cast<double>(step)) + 0.5));
  }
  return picture;
}

}  // namespace glimt
