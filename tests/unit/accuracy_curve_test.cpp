// What glimt accuracy makes of its measurements.
#include <catch2/catch.hpp>

#include <cmath>

#include "app/accuracy/curve.h"

using namespace glimt;

namespace {

// A curve whose error is known at every number of samples.
AccuracyCurve curveOf(double stays, double slow, double fast, double seconds_per_sample) {
  AccuracyCurve curve = {"bounces", "2", "--bounces 2", stays, {}};
  for (int n = 1; n <= 256; n *= 2)
    curve.points.push_back(
        {n, n * seconds_per_sample, std::sqrt(stays * stays + slow / n + fast / std::pow(n, 1.5))});
  return curve;
}

}  // namespace

TEST_CASE("a fit finds the parts that a curve was made of, also where one is missing") {
  const auto [slow, fast] = GENERATE(table<double, double>({{0.2, 0.1}, {0.2, 0}, {0, 0.3}}));
  const CurveFit fit = fitOf(curveOf(0.03, slow, fast, 0.5));
  CHECK(fit.slow == Approx(slow).margin(1e-6));
  CHECK(fit.fast == Approx(fast).margin(1e-6));
  CHECK(fit.seconds_per_sample == Approx(0.5));
}

TEST_CASE("so many samples bring a curve's error to a goal, and none to one below what stays") {
  const CurveFit fit = fitOf(curveOf(0.03, 0.2, 0.1, 1));
  const double samples = fit.samplesFor(0.05).value();
  CHECK(fit.errorAfter(samples) <= 0.05);
  CHECK(fit.errorAfter(samples - 1) > 0.05);
  CHECK_FALSE(fit.samplesFor(0.03));
  CHECK_FALSE(fit.samplesFor(0.02));
}

TEST_CASE("the frontier holds what nothing beats in time and error at once") {
  AccuracyCurve slow{"", "", "", 0, {{1, 2, 0.5}, {2, 4, 0.1}}};
  AccuracyCurve fast{"bounces", "1", "--bounces 1", 0, {{1, 1, 0.4}, {2, 3, 0.3}, {4, 5, 0.2}}};
  const std::vector<FrontierPoint> frontier = frontierOf({slow, fast});
  REQUIRE(frontier.size() == 3);
  CHECK(frontier[0].curve == 1);
  CHECK(frontier[1].point.error == 0.3);
  CHECK(frontier[2].curve == 0);
}

TEST_CASE("what is recommended is the cheapest that reaches the goal and can be asked for") {
  AccuracyCurve asked = curveOf(0, 0.2, 0, 1);
  AccuracyCurve cheap = curveOf(0.08, 0.2, 0, 0.5);
  AccuracyCurve unasked = curveOf(0, 0.2, 0, 0.1);
  unasked.options.clear();
  const std::vector<Recommendation> ways = recommendationsOf({asked, cheap, unasked});
  REQUIRE(ways.size() == 5);
  CHECK(ways[0].goal == 0.1);
  CHECK(ways[0].curve == 0);  // 20 samples against 56 at half the time
  CHECK(ways[1].curve == 0);
  CHECK(ways[1].samples == Approx(80).margin(1));
  cheap.stays = 0.01;
  CHECK(recommendationsOf({asked, cheap, unasked})[1].curve == 1);
}

TEST_CASE("a curve comes back from JSON as it was") {
  const AccuracyCurve curve = curveOf(0.01, 0.2, 0.1, 0.3);
  const AccuracyCurve again = accuracyCurveOf(Json::parse(jsonOf(curve).dump()));
  CHECK(again.name() == "bounces 2");
  CHECK(again.stays == curve.stays);
  CHECK(again.points.size() == curve.points.size());
  CHECK(again.points[3].error == curve.points[3].error);
}
