#include "renderer/passes/sheen_albedo.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace glimt {
namespace {

constexpr double kPi = std::numbers::pi;
constexpr int kHeights = 48;  // of the quadrature
constexpr int kTurns = 24;

// As in shaders/sheen.glsl.
double fit(double cosine, double alpha) {
  const double m = (1 - alpha) * (1 - alpha);
  const double a = std::lerp(21.5473, 25.3245, m);
  const double b = std::lerp(3.82987, 3.32435, m);
  const double c = std::lerp(0.19823, 0.16801, m);
  const double d = std::lerp(-1.97760, -1.27393, m);
  const double e = std::lerp(-4.32054, -4.85967, m);
  return a / (1 + b * std::pow(std::max(cosine, 1e-6), c)) + d * cosine + e;
}

double lambda(double cosine, double alpha) {
  if (cosine < 0.5) return std::exp(fit(cosine, alpha));
  return std::exp(2 * fit(0.5, alpha) - fit(1 - cosine, alpha));
}

double distribution(double normal_z, double alpha) {
  const double exponent = 1 / alpha;
  const double sine2 = std::max(1 - normal_z * normal_z, 1e-6);
  return (2 + exponent) * std::pow(sine2, 0.5 * exponent) / (2 * kPi);
}

}  // namespace

// Heights go by a square: much is reflected near the horizon.
double sheenAlbedoOf(double cosine, double roughness) {
  const double alpha = std::max(roughness * roughness, 0.04);
  const double sine = std::sqrt(std::max(1 - cosine * cosine, 0.0));
  const double lambda_o = lambda(cosine, alpha);
  double sum = 0;
  for (int i = 0; i < kHeights; ++i) {
    const double s = (i + 0.5) / kHeights;
    const double height = s * s;
    const double masking = 1 / (1 + lambda_o + lambda(height, alpha));
    const double radius = std::sqrt(1 - height * height);
    double around = 0;
    for (int j = 0; j < kTurns; ++j) {
      const double turn = kPi * (j + 0.5) / kTurns;
      const double x = sine + radius * std::cos(turn);
      const double y = radius * std::sin(turn);
      const double z = cosine + height;
      around += distribution(z / std::sqrt(x * x + y * y + z * z), alpha);
    }
    sum += masking * around * 2 * s;
  }
  return sum * 2 * kPi / (kHeights * kTurns) / (4 * cosine);
}

}  // namespace glimt
