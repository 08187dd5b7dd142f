#include <imgui.h>

#include "app/viewer/panel/panel.h"
#include "renderer/core/wording.h"

namespace glimt {
namespace {

void drawOpening(const PanelData& data, PanelFields& fields, PanelWishes& wishes) {
  // Until the field takes the keys: it may first have to be scrolled to.
  if (fields.typing_path) {
    ImGui::SetScrollHereY();
    ImGui::SetKeyboardFocusHere();
  }
  const bool entered =
      ImGui::InputTextWithHint("##path", "path of a scene, or drop one", fields.path.data(),
                               fields.path.size(), ImGuiInputTextFlags_EnterReturnsTrue);
  if (ImGui::IsItemActive()) fields.typing_path = false;
  ImGui::SameLine();
  const bool pressed = ImGui::Button("Open");
  if ((entered || pressed) && fields.path[0] != 0) wishes.open = fields.path.data();
  for (const std::filesystem::path& recent : data.recent) {
    ImGui::PushID(recent.c_str());
    if (ImGui::Selectable(printable(recent.filename().string()).c_str())) wishes.open = recent;
    if (ImGui::IsItemHovered()) ImGui::SetTooltip("%s", printable(recent.string()).c_str());
    ImGui::PopID();
  }
}

void drawSaving(const PanelData& data, PanelFields& fields, PanelWishes& wishes) {
  ImGui::InputText("##picture", fields.picture.data(), fields.picture.size());
  ImGui::SameLine();
  ImGui::TextUnformatted(".png .exr");
  ImGui::InputInt2(named("##pixels"), fields.picture_size.data());
  ImGui::InputInt(named("##samples"), &fields.picture_samples);
  if (data.saving) {
    ImGui::ProgressBar(*data.saving, {ImGui::GetFontSize() * 10, 0});
    ImGui::SameLine();
    if (ImGui::Button("Cancel")) wishes.cancel_saving = true;
  } else if (ImGui::Button("Render to a file")) {
    wishes.save_picture =
        SavedPicture{fields.picture.data(), fields.picture_size, fields.picture_samples};
  }
  if (ImGui::Button("Copy as a command line")) wishes.copy_command = true;
}

}  // namespace

void drawFileSection(const PanelData& data, PanelFields& fields, PanelWishes& wishes) {
  drawOpening(data, fields, wishes);
  if (data.scene == nullptr) return;
  ImGui::Separator();
  drawSaving(data, fields, wishes);
}

}  // namespace glimt
