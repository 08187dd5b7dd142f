#include "app/render_report.h"

#include <fmt/format.h>

#include <array>
#include <cmath>

#include "renderer/core/wording.h"

namespace glimt {
namespace {

Json secondsOf(const RenderReport& report) {
  const auto rounded = [](double seconds) { return std::round(seconds * 1e6) / 1e6; };
  return {{"load", rounded(report.load)},
          {"bvh", rounded(report.statistics.bvh_seconds)},
          {"compile", rounded(report.statistics.compile_seconds)},
          {"first_sample", rounded(report.first_sample)},
          {"render", rounded(report.render)},
          {"noise", rounded(report.statistics.noise_seconds)},
          {"denoise", rounded(report.denoise)},
          {"total", rounded(report.total)},
          {"measure_limits", rounded(report.measure_limits)}};
}

// What a sample took with each traversal that was tried; null where none was.
Json traversalSecondsOf(const RenderReport& report) {
  Json seconds;
  for (const TraversalTime& time : report.statistics.traversal_times)
    seconds[time.traversal] = std::round(time.seconds_per_sample * 1e6) / 1e6;
  return seconds;
}

// Rays are counted in one sample; the others cast about as many.
Json raysOf(const RenderReport& report) {
  const auto all = [&](double rays) {
    return static_cast<std::int64_t>(std::llround(rays * report.samples));
  };
  return {{"camera", all(report.statistics.camera_rays)},
          {"bounce", all(report.statistics.bounce_rays)},
          {"shadow", all(report.statistics.shadow_rays)}};
}

std::string nameOf(EndedBy limit) {
  constexpr std::array kNames{"samples", "time", "noise", "interrupt", "failure"};
  return kNames[static_cast<std::size_t>(limit)];
}

// What the true noise is below in the share of cases that `confidence` says, and what it is likely
// to be.
Json noiseOf(const RenderReport& report) {
  if (!report.noise) return nullptr;
  return {{"relative", report.noise->upper},
          {"confidence", 0.95},
          {"likely", report.noise->relative},
          {"low", report.noise->lower},
          {"exponent", report.noise->exponent()}};
}

// Noise and limits have nothing to do with each other, so their squares add up.
double errorOf(const NoiseEstimate& noise, const LimitError& limits) {
  return std::hypot(noise.relative, limits.both);
}

// What the limits cost, where it is at least half of what the noise does.
std::string limitsText(const RenderReport& report) {
  if (!report.limits) return "";
  const LimitError& limits = *report.limits;
  const double worth_it = 0.5 * report.noise->relative;
  std::string text;
  if (limits.truncation >= worth_it)
    text += fmt::format(", {} beyond {} (--bounces {} would do)", percent(limits.truncation),
                        counted(static_cast<std::uintmax_t>(report.settings.bounces), "bounce"),
                        limits.enough_bounces);
  if (limits.clamp >= worth_it) text += fmt::format(", {} clamped", percent(limits.clamp));
  return text;
}

// Where parts of the picture rested, others have more.
std::string samplesText(const RenderReport& report) {
  const std::string samples = counted(report.samples, "sample");
  if (!(report.mean_samples < report.samples - 0.5)) return samples;
  return fmt::format("{}, {:.0f} on average,", samples, report.mean_samples);
}

// As far as the noise is known.
std::string noiseText(const RenderReport& report) {
  if (!report.noise) return "";
  std::string goal;
  if (report.noise_goal)
    goal = fmt::format(", {} {}",
                       report.noise->upper <= *report.noise_goal ? "which is within" : "not",
                       percent(*report.noise_goal));
  return fmt::format(", noise {} (at most {}{})", percent(report.noise->relative),
                     percent(report.noise->upper), goal);
}

// The traversal in use and, where it was chosen by a measurement, how much faster it is than the
// next one.
std::string traversalOf(const RenderReport& report) {
  const std::string& chosen = report.statistics.traversal;
  const auto& times = report.statistics.traversal_times;
  double own = 0;
  double other = 0;
  for (const TraversalTime& time : times) {
    if (time.traversal == chosen)
      own = time.seconds_per_sample;
    else if (other == 0 || time.seconds_per_sample < other)
      other = time.seconds_per_sample;
  }
  if (times.empty()) return chosen;
  return fmt::format("{} ({:.2f} times as fast as the next)", chosen, other / own);
}

}  // namespace

Json jsonOf(const RenderReport& report) {
  Json json = {{"scene", report.scene.string()},
               {"width", report.settings.width},
               {"height", report.settings.height},
               {"samples", report.samples},
               {"mean_samples", report.mean_samples},
               {"bounces", report.settings.bounces},
               {"backend", report.context.backend},
               {"gl_renderer", report.context.renderer},
               {"gl_version", report.context.version},
               {"gles", report.context.gles},
               {"traversal", report.statistics.traversal},
               {"traversal_seconds", traversalSecondsOf(report)},
               {"record", report.settings.record},
               {"triangles", report.statistics.triangles},
               {"effects", report.effects},
               {"seconds", secondsOf(report)},
               {"rays", raysOf(report)},
               {"noise", noiseOf(report)},
               {"denoised", report.denoised},
               {"ended_by", nameOf(report.ended_by)},
               {"truncation", nullptr},
               {"enough_bounces", nullptr},
               {"clamped", nullptr},
               {"error", nullptr},
               {"nonfinite_pixels", report.nonfinite_pixels},
               {"warnings", report.warnings}};
  if (report.limits) {
    json["truncation"] = report.limits->truncation;
    json["enough_bounces"] = report.limits->enough_bounces;
    json["clamped"] = report.limits->clamp;
    json["error"] = errorOf(*report.noise, *report.limits);
  }
  if (!report.forecast.empty()) json["forecast"] = jsonOf(report.forecast);
  return json;
}

std::string warningOf(int nonfinite_pixels, const Losses& last,
                      const std::optional<std::uint32_t>& loop_limit) {
  const std::string pixels = counted(static_cast<std::uintmax_t>(nonfinite_pixels), "pixel");
  const std::string steps =
      loop_limit ? fmt::format("rays that took more steps than the {} this driver allows",
                               grouped(*loop_limit))
                 : "rays that took too many steps";
  const std::string values = "values that were not finite";
  if (last.cut_short == 0 && last.not_finite == 0)
    return fmt::format("{} lost samples: {}, or {}", pixels, values, steps);
  std::string causes;
  if (last.cut_short > 0) causes = fmt::format("{} to {}", grouped(last.cut_short), steps);
  if (last.not_finite > 0)
    causes +=
        fmt::format("{}{} to {}", causes.empty() ? "" : ", ", grouped(last.not_finite), values);
  return fmt::format("{} lost samples, in the last one {}", pixels, causes);
}

std::string summaryOf(const RenderReport& report) {
  std::string files;
  for (const auto& output : report.outputs) {
    files += (files.empty() ? "" : ", ") + output.string();
  }
  // "llvmpipe (LLVM 15.0.6, 256 bits)" says more than the line has room for.
  const std::string& gl = report.context.renderer;
  const std::string device = gl.substr(0, gl.find(" ("));
  const std::string denoised =
      report.denoised ? fmt::format(", denoised in {:.1f} s", report.denoise) : "";
  return fmt::format("{}: {} in {:.1f} s ({:.3g} samples/s){}{}{}, {}, {}, {}", files,
                     samplesText(report), report.render, report.samples / report.render,
                     noiseText(report), denoised, limitsText(report),
                     counted(report.statistics.triangles, "triangle"), traversalOf(report), device);
}

}  // namespace glimt
