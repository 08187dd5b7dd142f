#include "app/accuracy/curve.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace glimt {
namespace {

constexpr std::array kGoals{0.1, 0.05, 0.02, 0.01, 0.005};
constexpr double kMostSamples = 1e9;

// Times are of a machine that may do other work: what is cheaper by less is as cheap.
constexpr double kClearly = 0.9;

// Sums of a least-squares fit of y = slow * u + fast * v.
struct Sums {
  double uu = 0, uv = 0, vv = 0, uy = 0, vy = 0;
};

Sums sumsOf(const AccuracyCurve& curve) {
  Sums sums;
  for (const AccuracyPoint& point : curve.points) {
    const double y = point.error * point.error - curve.stays * curve.stays;
    if (!(y > 0)) continue;
    // Relative to y, so that small errors count as large ones do.
    const double u = 1 / (point.samples * y);
    const double v = u / std::sqrt(point.samples);
    sums.uu += u * u;
    sums.uv += u * v;
    sums.vv += v * v;
    sums.uy += u;
    sums.vy += v;
  }
  return sums;
}

}  // namespace

double CurveFit::errorAfter(double samples) const {
  return std::sqrt(stays * stays + slow / samples + fast / (samples * std::sqrt(samples)));
}

std::optional<double> CurveFit::samplesFor(double goal) const {
  if (!(errorAfter(kMostSamples) < goal)) return std::nullopt;
  double low = 0;
  double high = kMostSamples;
  while (high - low > 0.5)
    (errorAfter(0.5 * (low + high)) < goal ? high : low) = 0.5 * (low + high);
  return std::max(std::ceil(high), 1.0);
}

// Neither part is negative: where one would be, the other is all there is.
CurveFit fitOf(const AccuracyCurve& curve) {
  CurveFit fit;
  fit.stays = curve.stays;
  if (curve.points.empty()) return fit;
  fit.seconds_per_sample = curve.points.back().seconds / curve.points.back().samples;
  const Sums sums = sumsOf(curve);
  const double determinant = sums.uu * sums.vv - sums.uv * sums.uv;
  if (determinant > 1e-9 * sums.uu * sums.vv) {
    fit.slow = (sums.uy * sums.vv - sums.vy * sums.uv) / determinant;
    fit.fast = (sums.vy * sums.uu - sums.uy * sums.uv) / determinant;
  }
  const bool only_fast = fit.slow < 0;
  if (only_fast || fit.fast < 0 || fit.slow + fit.fast == 0) {
    fit.slow = only_fast || sums.uu == 0 ? 0 : sums.uy / sums.uu;
    fit.fast = only_fast && sums.vv > 0 ? sums.vy / sums.vv : 0;
  }
  return fit;
}

std::vector<FrontierPoint> frontierOf(const std::vector<AccuracyCurve>& curves) {
  std::vector<FrontierPoint> all;
  for (std::size_t i = 0; i < curves.size(); ++i)
    for (const AccuracyPoint& point : curves[i].points) all.push_back({i, point});
  std::stable_sort(all.begin(), all.end(), [](const FrontierPoint& a, const FrontierPoint& b) {
    return a.point.seconds < b.point.seconds;
  });
  std::vector<FrontierPoint> frontier;
  for (const FrontierPoint& point : all)
    if (frontier.empty() || point.point.error < frontier.back().point.error)
      frontier.push_back(point);
  return frontier;
}

std::vector<Recommendation> recommendationsOf(const std::vector<AccuracyCurve>& curves) {
  std::vector<Recommendation> out;
  for (const double goal : kGoals) {
    std::optional<Recommendation> best;
    for (std::size_t i = 0; i < curves.size(); ++i) {
      if (i > 0 && curves[i].options.empty()) continue;
      const CurveFit fit = fitOf(curves[i]);
      const std::optional<double> samples = fit.samplesFor(goal);
      if (!samples || fit.seconds_per_sample == 0) continue;
      const double seconds = *samples * fit.seconds_per_sample;
      if (!best || seconds < kClearly * best->seconds)
        best = Recommendation{goal, i, *samples, seconds};
    }
    if (best) out.push_back(*best);
  }
  return out;
}

Json jsonOf(const AccuracyCurve& curve) {
  Json points = Json::array();
  for (const AccuracyPoint& point : curve.points)
    points.push_back({{"samples", point.samples},
                      {"seconds", point.seconds},
                      {"error", point.error},
                      {"noise", point.noise}});
  return {{"knob", curve.knob},
          {"value", curve.value},
          {"options", curve.options},
          {"stays", curve.stays},
          {"points", points}};
}

AccuracyCurve accuracyCurveOf(const Json& json) {
  AccuracyCurve curve{json.at("knob"), json.at("value"), json.at("options"), json.at("stays"), {}};
  for (const Json& point : json.at("points"))
    curve.points.push_back(
        {point.at("samples"), point.at("seconds"), point.at("error"), point.value("noise", 0.0)});
  return curve;
}

}  // namespace glimt
