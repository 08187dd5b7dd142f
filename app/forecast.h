// What better pictures of a scene would take.
#pragma once

#include <string>
#include <vector>

#include "app/json_output.h"
#include "renderer/core/noise_estimate.h"

namespace glimt {

struct ForecastRow {
  double noise = 0;  // a share of 1, reached with 95% confidence
  double samples = 0;
  double seconds = 0;  // from the start of the command
};

// For noise of 10% to 0.5%. `seconds_before` is what passed until sampling began.
std::vector<ForecastRow> forecast(const NoiseEstimate& noise, double seconds_per_sample,
                                  double seconds_before);

// A table for people.
std::string textOf(const std::vector<ForecastRow>& rows);

Json jsonOf(const std::vector<ForecastRow>& rows);

}  // namespace glimt
