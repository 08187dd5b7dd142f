// Error against time, both on logarithmic axes.
#pragma once

#include <string>
#include <vector>

#include "app/accuracy/curve.h"

namespace glimt {

struct ChartCurve {
  std::string name;
  std::vector<AccuracyPoint> points;
};

// As SVG. The first curve is drawn dark, the others in colours. `marked` are encircled, with
// nothing said of them but what `note` says.
std::string errorTimeChart(const std::string& title, const std::vector<ChartCurve>& curves,
                           const std::vector<AccuracyPoint>& marked, const std::string& note);

}  // namespace glimt
