#include <imgui.h>

#include "app/viewer/panel/panel.h"
#include "renderer/core/wording.h"

namespace glimt {
namespace {

// A button that looks pressed where it is the one in force.
bool choice(const char* name, bool chosen) {
  if (chosen) ImGui::PushStyleColor(ImGuiCol_Button, ImGui::GetStyle().Colors[ImGuiCol_SliderGrab]);
  const bool pressed = ImGui::Button(name);
  if (chosen) ImGui::PopStyleColor();
  return pressed && !chosen;
}

// On the same line while there is room.
void nextTo(const std::string& name) {
  const ImGuiStyle& style = ImGui::GetStyle();
  const float width = ImGui::CalcTextSize(name.c_str()).x + 2 * style.FramePadding.x;
  const float end = ImGui::GetWindowPos().x + ImGui::GetWindowContentRegionMax().x;
  if (ImGui::GetItemRectMax().x + style.ItemSpacing.x + width <= end) ImGui::SameLine();
}

bool enabledButton(const char* name, bool enabled) {
  ImGui::BeginDisabled(!enabled);
  const bool pressed = ImGui::Button(name);
  ImGui::EndDisabled();
  return pressed;
}

}  // namespace

void drawVariantSection(const PanelData& data, ViewerState& state, PanelWishes& wishes) {
  const std::vector<std::string>& variants = data.scene->scene.variants;
  if (!variants.empty()) {
    if (choice("as made", state.look.variant.empty())) wishes.variant = "";
    for (const std::string& variant : variants) {
      const std::string name = printable(variant);
      nextTo(name);
      if (choice(name.c_str(), state.look.variant == variant)) wishes.variant = variant;
    }
  }
  if (enabledButton("Undo", data.can_undo)) wishes.undo = true;
  ImGui::SameLine();
  if (enabledButton("Redo", data.can_redo)) wishes.redo = true;
  ImGui::SameLine();
  if (ImGui::Button("Save")) wishes.save_scene = true;
  if (ImGui::IsItemHovered()) ImGui::SetTooltip("as a scene file beside the model");
  ImGui::SameLine();
  if (ImGui::Button(data.comparing ? "End" : "Compare")) wishes.compare = true;
  if (ImGui::IsItemHovered())
    ImGui::SetTooltip(data.comparing ? "end comparing" : "keep this look on the left");
}

}  // namespace glimt
