#include <imgui.h>

#include "app/viewer/panel/panel.h"

namespace glimt {

void drawLightSection(const PanelData& data, ViewerState& state) {
  Look& look = state.look;
  ImGui::SliderFloat("exposure", &look.exposure, -8, 8, "%+.1f EV");
  int tone = static_cast<int>(look.tone);
  if (ImGui::Combo("tone", &tone, kToneNames.data(), static_cast<int>(kToneNames.size())))
    look.tone = static_cast<Tone>(tone);
  const Environment& environment = data.scene->scene.environment;
  const bool picture = !environment.image.pixels.empty();
  if (!picture && environment.color == Vec3(0)) {
    ImGui::TextDisabled("no light from outside");
    return;
  }
  ImGui::SliderFloat("surroundings", &look.environment_strength, 0, 10, "x %.2f",
                     ImGuiSliderFlags_Logarithmic);
  if (!picture) return;
  ImGui::SliderFloat("rotation", &look.environment_rotation, -180, 180, "%.0f deg");
  if (ImGui::IsItemHovered()) ImGui::SetTooltip("or drag the picture with Shift");
}

}  // namespace glimt
