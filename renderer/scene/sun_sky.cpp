#include "renderer/scene/sun_sky.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "renderer/core/vector.h"

namespace glimt {
namespace {

constexpr int kWidth = 1024;
constexpr int kHeight = 512;
constexpr double kPi = std::numbers::pi;
constexpr double kUnit = 100 / kPi;  // kcd / m^2 of radiance 1
constexpr double kSunRadius = 0.2665 * kPi / 180;
constexpr double kSunIlluminance = 133;  // klx, outside the atmosphere
constexpr double kGroundReflectance = 0.2;

using Color = glm::dvec3;

glm::dvec3 directionAt(double x, double y) {
  const double around = 2 * kPi * (x / kWidth - 0.5);
  const double down = kPi * y / kHeight;
  return {std::sin(down) * std::cos(around), std::cos(down), std::sin(down) * std::sin(around)};
}

double solidAngle(int y) {
  return (std::cos(kPi * y / kHeight) - std::cos(kPi * (y + 1) / kHeight)) * 2 * kPi / kWidth;
}

// Perez' distribution: of a luminance or a chromaticity over the sky.
struct Perez {
  double a, b, c, d, e;
  double at(double cosine, double angle) const {
    const double cosine_angle = std::cos(angle);
    return (1 + a * std::exp(b / cosine)) *
           (1 + c * std::exp(d * angle) + e * cosine_angle * cosine_angle);
  }
};

Color linearSrgb(double x, double y, double luminance) {
  const double big_x = luminance * x / y;
  const double big_z = luminance * (1 - x - y) / y;
  return glm::max(Color(3.2406 * big_x - 1.5372 * luminance - 0.4986 * big_z,
                        -0.9689 * big_x + 1.8758 * luminance + 0.0415 * big_z,
                        0.0557 * big_x - 0.2040 * luminance + 1.0570 * big_z),
                  Color(0));
}

class Sky {
 public:
  Sky(double turbidity, double sun_zenith, const glm::dvec3& sun)
      : sun_(sun), sun_zenith_(sun_zenith) {
    const double t = turbidity;
    luminance_ = {0.1787 * t - 1.4630, -0.3554 * t + 0.4275, -0.0227 * t + 5.3251,
                  0.1206 * t - 2.5771, -0.0670 * t + 0.3703};
    x_ = {-0.0193 * t - 0.2592, -0.0665 * t + 0.0008, -0.0004 * t + 0.2125, -0.0641 * t - 0.8989,
          -0.0033 * t + 0.0452};
    y_ = {-0.0167 * t - 0.2608, -0.0950 * t + 0.0092, -0.0079 * t + 0.2102, -0.0441 * t - 1.6537,
          -0.0109 * t + 0.0529};
    const double chi = (4.0 / 9 - t / 120) * (kPi - 2 * sun_zenith);
    const double z = sun_zenith;
    const auto cubic = [z](double a, double b, double c, double d) {
      return ((a * z + b) * z + c) * z + d;
    };
    zenith_luminance_ = std::max((4.0453 * t - 4.9710) * std::tan(chi) - 0.2155 * t + 2.4192, 0.0);
    zenith_x_ = t * t * cubic(0.00166, -0.00375, 0.00209, 0) +
                t * cubic(-0.02903, 0.06377, -0.03202, 0.00394) +
                cubic(0.11693, -0.21196, 0.06052, 0.25886);
    zenith_y_ = t * t * cubic(0.00275, -0.00610, 0.00317, 0) +
                t * cubic(-0.04214, 0.08970, -0.04153, 0.00516) +
                cubic(0.15346, -0.26756, 0.06670, 0.26688);
  }

  // kcd / m^2, of a direction above the horizon.
  Color at(const glm::dvec3& direction) const {
    constexpr double kLeastCosine = 0.01;  // the model has no end at the horizon
    const double cosine = std::max(direction.y, kLeastCosine);
    const double angle = std::acos(std::clamp(glm::dot(direction, sun_), -1.0, 1.0));
    const auto scaled = [&](double zenith, const Perez& perez) {
      return zenith * perez.at(cosine, angle) / perez.at(1, sun_zenith_);
    };
    return linearSrgb(scaled(zenith_x_, x_), scaled(zenith_y_, y_),
                      scaled(zenith_luminance_, luminance_));
  }

 private:
  glm::dvec3 sun_;
  double sun_zenith_;
  Perez luminance_{}, x_{}, y_{};
  double zenith_luminance_ = 0;
  double zenith_x_ = 0;
  double zenith_y_ = 0;
};

// klx, of a surface that faces the sun: what Rayleigh scattering, aerosols and ozone leave of it.
Color sunIlluminance(double turbidity, double sun_zenith) {
  constexpr std::array kWavelengths{0.61, 0.55,
                                    0.465};          // micrometres, about those of sRGB's colours
  constexpr std::array kOzone{0.115, 0.085, 0.010};  // per centimetre
  constexpr double kOzoneDepth = 0.35;               // centimetres
  const double degrees = sun_zenith * 180 / kPi;
  const double mass =
      1 / (std::cos(sun_zenith) + 0.15 * std::pow(93.885 - std::min(degrees, 90.0), -1.253));
  const double beta = std::max(0.04608 * turbidity - 0.04586, 0.0);
  Color light;
  for (int c = 0; c < 3; ++c) {
    const auto i = static_cast<std::size_t>(c);
    const double depth = 0.008735 * std::pow(kWavelengths[i], -4.08) +
                         beta * std::pow(kWavelengths[i], -1.3) + kOzone[i] * kOzoneDepth;
    light[c] = kSunIlluminance * std::exp(-depth * mass);
  }
  return light;
}

// The part of a pixel that the sun covers.
double coverage(int x, int y, const glm::dvec3& sun) {
  constexpr int kSteps = 8;
  if (glm::dot(directionAt(x + 0.5, y + 0.5), sun) < std::cos(kSunRadius + 2 * kPi / kHeight))
    return 0;
  int inside = 0;
  for (int v = 0; v < kSteps; ++v)
    for (int u = 0; u < kSteps; ++u)
      inside += glm::dot(directionAt(x + (u + 0.5) / kSteps, y + (v + 0.5) / kSteps), sun) >
                std::cos(kSunRadius);
  return static_cast<double>(inside) / (kSteps * kSteps);
}

// Divides the sun's light among the pixels that it covers.
void addSun(std::vector<Color>& pixels, const Color& illuminance, const glm::dvec3& sun) {
  std::vector<double> parts(pixels.size());
  double covered = 0;
  for (int y = 0; y < kHeight; ++y)
    for (int x = 0; x < kWidth; ++x) {
      const auto i = static_cast<std::size_t>(y) * kWidth + static_cast<std::size_t>(x);
      parts[i] = coverage(x, y, sun);
      covered += parts[i] * solidAngle(y);
    }
  for (std::size_t i = 0; i < pixels.size(); ++i) pixels[i] += illuminance * (parts[i] / covered);
}

// klx, of the ground.
Color illuminanceOfGround(const std::vector<Color>& pixels) {
  Color sum(0);
  for (int y = 0; y < kHeight / 2; ++y)
    for (int x = 0; x < kWidth; ++x)
      sum += pixels[static_cast<std::size_t>(y) * kWidth + static_cast<std::size_t>(x)] *
             (solidAngle(y) * directionAt(x + 0.5, y + 0.5).y);
  return sum;
}

}  // namespace

Image makeSunSky(const SunSky& settings) {
  const double elevation = settings.elevation * kPi / 180;
  const double rotation = settings.rotation * kPi / 180;
  const glm::dvec3 sun(std::cos(elevation) * std::cos(rotation), std::sin(elevation),
                       -std::cos(elevation) * std::sin(rotation));
  const double turbidity = settings.turbidity;
  const Sky sky(turbidity, kPi / 2 - elevation, sun);
  std::vector<Color> pixels;
  pixels.reserve(static_cast<std::size_t>(kWidth) * kHeight);
  for (int y = 0; y < kHeight; ++y)
    for (int x = 0; x < kWidth; ++x)
      pixels.push_back(y < kHeight / 2 ? sky.at(directionAt(x + 0.5, y + 0.5)) : Color(0));
  addSun(pixels, sunIlluminance(turbidity, kPi / 2 - elevation), sun);
  const Color ground = illuminanceOfGround(pixels) * (kGroundReflectance / kPi);
  Image image{kWidth, kHeight, {}};
  image.pixels.reserve(pixels.size());
  for (std::size_t i = 0; i < pixels.size(); ++i)
    image.pixels.emplace_back((i < pixels.size() / 2 ? pixels[i] : ground) / kUnit);
  return image;
}

}  // namespace glimt
