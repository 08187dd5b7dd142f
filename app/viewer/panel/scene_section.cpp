#include <fmt/format.h>
#include <imgui.h>

#include "app/viewer/panel/panel.h"
#include "renderer/core/wording.h"

namespace glimt {

void drawSceneSection(const PanelData& data) {
  const Scene& scene = data.scene->scene;
  const RenderStatistics& statistics = data.status.statistics;
  drawRow("name", printable(scene.name));
  drawRow("triangles", grouped(scene.triangles.size()));
  drawRow("materials", grouped(scene.materials.size()));
  drawRow("textures", grouped(scene.images.size()));
  drawRow("tree", fmt::format("{} nodes", grouped(statistics.nodes)));
  drawRow("on the GPU",
          fmt::format("{:.3g} MB", 1e-6 * static_cast<double>(statistics.texture_bytes)));
  drawRow("loading", duration(data.scene->load_seconds));
  ImGui::PushTextWrapPos(0);
  ImGui::PushStyleColor(ImGuiCol_Text, {0.95f, 0.78f, 0.4f, 1});
  for (const auto* warnings : {&scene.warnings, &statistics.warnings})
    for (const std::string& warning : *warnings) ImGui::TextUnformatted(printable(warning).c_str());
  ImGui::PopStyleColor();
  ImGui::PopTextWrapPos();
}

}  // namespace glimt
