// How the error of a variant falls with time.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/json_output.h"

namespace glimt {

struct AccuracyPoint {
  int samples = 0;
  double seconds = 0;  // of sampling
  double error = 0;    // against the reference, without what the reference itself is wrong by; as
                       // NoiseEstimate defines it
  double noise = 0;    // as it was estimated while rendering; 0 where it was not known yet
};

struct AccuracyCurve {
  std::string knob;  // as in AccuracyVariant
  std::string value;
  std::string options;
  double stays = 0;  // what is left of the error however many samples there are: see LimitError
  std::vector<AccuracyPoint> points;

  std::string name() const { return knob.empty() ? "as asked" : knob + " " + value; }
};

// The error is that of the limits, which stays, and the noise, which falls with the samples n as
// that of low-discrepancy points does: error^2 = stays^2 + slow / n + fast / n^1.5.
struct CurveFit {
  double stays = 0;
  double slow = 0;
  double fast = 0;
  double seconds_per_sample = 0;

  double errorAfter(double samples) const;
  // Samples until the error is `goal`; none where it stays above.
  std::optional<double> samplesFor(double goal) const;
};

// Least squares, relative, over the points whose error is above what stays.
CurveFit fitOf(const AccuracyCurve& curve);

// What is not better in one way than another without being worse in the other: of all points, by
// seconds.
struct FrontierPoint {
  std::size_t curve = 0;
  AccuracyPoint point;
};
std::vector<FrontierPoint> frontierOf(const std::vector<AccuracyCurve>& curves);

// The cheapest way to an error, by the fits: what was asked for, which is the first, or a curve
// with options for the command line that is clearly cheaper.
struct Recommendation {
  double goal = 0;
  std::size_t curve = 0;
  double samples = 0;
  double seconds = 0;
};
std::vector<Recommendation> recommendationsOf(const std::vector<AccuracyCurve>& curves);

Json jsonOf(const AccuracyCurve& curve);
AccuracyCurve accuracyCurveOf(const Json& json);

}  // namespace glimt
