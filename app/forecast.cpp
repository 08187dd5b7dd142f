#include "app/forecast.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "renderer/core/wording.h"

namespace glimt {
namespace {

constexpr std::array kGoals{0.1, 0.05, 0.02, 0.01, 0.005};

}  // namespace

std::vector<ForecastRow> forecast(const NoiseEstimate& noise, double seconds_per_sample,
                                  double seconds_before) {
  std::vector<ForecastRow> rows;
  for (const double goal : kGoals) {
    const double samples = std::max(std::ceil(noise.samplesFor(goal)), 1.0);
    rows.push_back({goal, samples, seconds_before + samples * seconds_per_sample});
  }
  return rows;
}

std::string textOf(const std::vector<ForecastRow>& rows) {
  std::string text = fmt::format("{:>7}{:>14}{:>10}\n", "noise", "samples", "time");
  for (const ForecastRow& row : rows)
    text += fmt::format("{:>7}{:>14}{:>10}\n", percent(row.noise),
                        grouped(static_cast<std::uintmax_t>(row.samples)), duration(row.seconds));
  return text;
}

Json jsonOf(const std::vector<ForecastRow>& rows) {
  Json table = Json::array();
  for (const ForecastRow& row : rows)
    table.push_back({{"noise", row.noise}, {"samples", row.samples}, {"seconds", row.seconds}});
  return table;
}

}  // namespace glimt
