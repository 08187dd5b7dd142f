#include <fmt/format.h>
#include <imgui.h>

#include <cmath>

#include "app/viewer/panel/panel.h"
#include "renderer/core/light_limits.h"
#include "renderer/core/wording.h"

namespace glimt {
namespace {

void drawBudget(const PanelData& data) {
  const LimitError& limits = *data.limits;
  const double noise = data.status.noise ? data.status.noise->relative : 0;
  drawRow("noise", data.status.noise ? percent(noise) : "not known yet");
  drawRow("bounces", percent(limits.truncation));
  if (limits.clamp > 0) drawRow("clamp", percent(limits.clamp));
  drawRow("in all", percent(std::hypot(noise, limits.both)));
  drawRow("enough",
          fmt::format("{} for this noise",
                      counted(static_cast<std::uintmax_t>(limits.enough_bounces), "bounce")));
}

}  // namespace

// What is wrong with the picture, in parts.
void drawAccuracySection(const PanelData& data, ViewerState& state, PanelWishes& wishes) {
  ImGui::SliderInt(named("##bounces"), &state.look.bounces, 0, 16);
  if (data.limits) drawBudget(data);
  if (data.measuring_limits) {
    ImGui::TextDisabled("measuring ...");
  } else if (data.status.noise) {
    if (ImGui::Button("Measure what the limits cost")) wishes.measure_limits = true;
  } else {
    ImGui::TextDisabled("the error's parts are known after 8 samples");
  }
}

}  // namespace glimt
