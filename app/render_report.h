// What a render did, for people and for programs.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "app/forecast.h"
#include "app/json_output.h"
#include "app/sampling.h"
#include "renderer/limit_error.h"
#include "renderer/renderer.h"

namespace glimt {

struct RenderReport {
  std::filesystem::path scene;
  std::vector<std::filesystem::path> outputs;
  RenderSettings settings;
  ContextInfo context;
  RenderStatistics statistics;
  std::vector<std::string> effects;  // those that are on
  int samples = 0;
  double mean_samples = 0;  // over the pixels
  int nonfinite_pixels = 0;
  std::optional<NoiseEstimate> noise;
  std::optional<double> noise_goal;
  std::optional<LimitError> limits;  // none where the noise is not known
  EndedBy ended_by = EndedBy::samples;
  std::vector<ForecastRow> forecast;  // where it was asked for
  bool denoised = false;              // the pictures; all figures are those of the samples
  // Seconds. `first_sample` is how long after the start the first sample was complete; `total` is
  // the whole command, from the start until the pictures were written.
  double load = 0;
  double first_sample = 0;
  double render = 0;
  double denoise = 0;
  double total = 0;
  double measure_limits = 0;  // what came after that
  std::vector<std::string> warnings;
};

Json jsonOf(const RenderReport& report);

// What pixels have lost samples to, as far as it is known: the last sample tells, and where it
// tells of traversals cut short, so does the number of turns after which the driver ends loops.
std::string warningOf(int nonfinite_pixels, const Losses& last,
                      const std::optional<std::uint32_t>& loop_limit);

// One line.
std::string summaryOf(const RenderReport& report);

}  // namespace glimt
