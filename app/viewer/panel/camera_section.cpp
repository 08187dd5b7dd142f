#include <imgui.h>

#include "app/viewer/panel/panel.h"
#include "renderer/core/wording.h"

namespace glimt {

void drawCameraSection(const PanelData& data, ViewerState& state, PanelWishes& wishes) {
  const std::vector<NamedCamera>& cameras = data.scene->scene.cameras;
  for (std::size_t i = 0; i < cameras.size(); ++i) {
    ImGui::PushID(static_cast<int>(i));
    const std::string name = cameras[i].name.empty() ? "camera" : printable(cameras[i].name);
    if (ImGui::Button(name.c_str())) wishes.camera = i;
    ImGui::PopID();
  }
  if (ImGui::Button("Frame")) wishes.frame = true;
  ImGui::SameLine();
  if (ImGui::Button("Back to the start")) wishes.reset = true;
  ImGui::Checkbox("turntable", &state.turntable);
}

}  // namespace glimt
