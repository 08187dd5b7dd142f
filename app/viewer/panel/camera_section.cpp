#include <imgui.h>

#include "app/viewer/panel/panel.h"
#include "renderer/core/wording.h"

namespace glimt {
namespace {

// The widest aperture, as a share of the distance to what is sharp.
constexpr float kWidest = 0.05f;

void drawLens(const Camera& camera, PanelWishes& wishes) {
  const float reach = glm::distance(camera.position, camera.target);
  Lens lens{camera.vertical_fov, camera.aperture_radius, camera.focus_distance};
  if (!(lens.aperture_radius > 0)) lens.focus_distance = reach;
  bool changed = ImGui::SliderFloat(named("##field of view"), &lens.vertical_fov, 5, 120,
                                    "%.0f deg", ImGuiSliderFlags_AlwaysClamp);
  changed |= ImGui::SliderFloat(named("##aperture"), &lens.aperture_radius, 0, kWidest * reach,
                                "radius %.3g m", ImGuiSliderFlags_AlwaysClamp);
  if (lens.aperture_radius > 0) {
    changed |=
        ImGui::SliderFloat(named("##sharp at"), &lens.focus_distance, 0.05f * reach, 10 * reach,
                           "%.3g m", ImGuiSliderFlags_Logarithmic | ImGuiSliderFlags_AlwaysClamp);
    if (ImGui::IsItemHovered()) ImGui::SetTooltip("or double click what is to be sharp");
  }
  if (changed) wishes.lens = lens;
}

}  // namespace

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
  ImGui::SameLine();
  ImGui::Checkbox("turntable", &state.turntable);
  if (!(data.camera.orthographic_height > 0)) drawLens(data.camera, wishes);
}

}  // namespace glimt
