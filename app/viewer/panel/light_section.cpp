#include <imgui.h>

#include <filesystem>

#include "app/viewer/panel/panel.h"
#include "renderer/core/wording.h"
#include "renderer/scene/environment_picture.h"

namespace glimt {
namespace {

constexpr const char* kOfFile = "as in the file";

// Pictures of surroundings are dropped on the window.
void drawEnvironments(const PanelData& data, PanelWishes& wishes) {
  const std::string chosen = data.scene->choice.settings.environment.image.value_or("");
  const std::string shown =
      chosen.empty() ? kOfFile : printable(std::filesystem::path(chosen).filename().string());
  if (ImGui::BeginCombo(named("##surroundings"), shown.c_str())) {
    if (ImGui::Selectable(kOfFile, chosen.empty())) wishes.environment = "";
    for (const char* const name : {kStudioName, kSunSkyName})
      if (ImGui::Selectable(name, chosen == name)) wishes.environment = name;
    ImGui::EndCombo();
  }
  if (ImGui::IsItemHovered()) ImGui::SetTooltip("or drop an .hdr or .exr picture on the window");
}

}  // namespace

void drawLightSection(const PanelData& data, ViewerState& state, PanelWishes& wishes) {
  Look& look = state.look;
  ImGui::SliderFloat(named("##exposure"), &look.exposure, -8, 8, "%+.1f EV");
  int tone = static_cast<int>(look.tone);
  if (ImGui::Combo(named("##tone"), &tone, kToneNames.data(), static_cast<int>(kToneNames.size())))
    look.tone = static_cast<Tone>(tone);
  drawEnvironments(data, wishes);
  const Environment& environment = data.scene->scene.environment;
  const bool picture = !environment.image.pixels.empty();
  if (!picture && environment.color == Vec3(0)) {
    ImGui::TextDisabled("no light from outside");
    return;
  }
  ImGui::SliderFloat(named("##strength"), &look.environment_strength, 0, 10, "x %.2f",
                     ImGuiSliderFlags_Logarithmic);
  if (!picture) return;
  ImGui::SliderFloat(named("##rotation"), &look.environment_rotation, -180, 180, "%.0f deg");
  if (ImGui::IsItemHovered()) ImGui::SetTooltip("or drag the picture with Shift");
}

}  // namespace glimt
