#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>

#include "app/viewer/panel/panel.h"
#include "renderer/core/wording.h"

namespace glimt {
namespace {

// Each of these fits into one line, so that nothing below moves while the numbers change.
std::string sizeText(const PanelData& data) {
  const int divisor = data.status.divisor;
  return fmt::format("{} x {}{}", data.size[0], data.size[1],
                     divisor > 1 ? fmt::format(", preview 1/{}", divisor) : "");
}

std::string samplesText(const PictureStatus& status) {
  if (status.samples == 0) return "first sample";
  return fmt::format("{}, {:.3g} a second", grouped(static_cast<std::uintmax_t>(status.samples)),
                     status.sample_rate);
}

std::string noiseText(const PictureStatus& status) {
  if (!status.noise) return status.divisor > 1 ? "after the preview" : "known after 8 samples";
  return fmt::format("{} ({} to {})", percent(status.noise->relative), percent(status.noise->lower),
                     percent(status.noise->upper));
}

std::string timeLeftText(const PictureStatus& status, double goal) {
  if (!status.noise) return "not known yet";
  if (status.noise->upper <= goal) return "reached";
  const double samples = std::max(status.noise->samplesFor(goal) - status.samples, 1.0);
  return duration(samples * status.secondsPerSample());
}

}  // namespace

void drawPictureSection(const PanelData& data, ViewerState& state) {
  const PictureStatus& status = data.status;
  drawRow("size", sizeText(data));
  drawRow("samples", samplesText(status));
  drawRow("time", duration(status.seconds));
  drawRow("noise now", noiseText(status));
  float goal = 100 * state.noise_goal;
  if (ImGui::SliderFloat(named("##noise goal"), &goal, 0.1f, 20, "%.2g%%",
                         ImGuiSliderFlags_Logarithmic))
    state.noise_goal = 0.01f * goal;
  drawRow("time left", timeLeftText(status, state.noise_goal));
  ImGui::Checkbox(named("##denoise"), &state.denoise);
  if (ImGui::IsItemHovered())
    ImGui::SetTooltip(
        "a guess at the picture without noise; the noise told is that of the samples,"
        "\nand they are what is saved");
  drawNoiseCurve(data.noise, state.noise_goal);
}

}  // namespace glimt
