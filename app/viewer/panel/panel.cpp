#include "app/viewer/panel/panel.h"

#include <imgui.h>

#include <algorithm>
#include <cfloat>

namespace glimt {
namespace {

// In heights of a line of text.
constexpr float kWidth = 22.5f;
constexpr float kNameWidth = 8;

bool beginSection(const char* name, bool open) {
  return ImGui::CollapsingHeader(name, open ? ImGuiTreeNodeFlags_DefaultOpen : 0);
}

void drawSections(const PanelData& data, ViewerState& state, PanelFields& fields,
                  PanelWishes& wishes) {
  // Whoever is to type a path must see where.
  const auto openFile = [&] {
    if (fields.typing_path) ImGui::SetNextItemOpen(true);
    return beginSection("File", false);
  };
  if (data.scene == nullptr) {
    if (beginSection("Open", true)) drawFileSection(data, fields, wishes);
    return;
  }
  if (beginSection("Picture", true)) drawPictureSection(data, state);
  if (beginSection("Variants and changes", true)) drawVariantSection(data, state, wishes);
  if (beginSection("Material", true)) drawMaterialSection(data, state);
  if (beginSection("Light", true)) drawLightSection(data, state, wishes);
  if (beginSection("Accuracy", false)) drawAccuracySection(data, state, wishes);
  if (beginSection("Camera", false)) drawCameraSection(data, state, wishes);
  if (openFile()) drawFileSection(data, fields, wishes);
  if (beginSection("Scene", false)) drawSceneSection(data);
  if (beginSection("Effects", false)) drawEffectsSection(data, wishes);
  if (beginSection("Device", false)) drawDeviceSection(data);
}

}  // namespace

float panelWidth(float window_width) {
  // Not GetFontSize(), which is unknown before the first frame.
  return std::min(kWidth * ImGui::GetIO().Fonts->Fonts.front()->FontSize, window_width);
}

const char* named(const char* id) {
  ImGui::AlignTextToFramePadding();
  ImGui::TextDisabled("%s", id + 2);
  ImGui::SameLine(kNameWidth * ImGui::GetFontSize());
  ImGui::SetNextItemWidth(-FLT_MIN);
  return id;
}

void drawRow(const char* name, const std::string& value) {
  ImGui::TextDisabled("%s", name);
  ImGui::SameLine(kNameWidth * ImGui::GetFontSize());
  ImGui::PushTextWrapPos(0);
  ImGui::TextUnformatted(value.c_str());
  ImGui::PopTextWrapPos();
}

PanelWishes drawPanel(const PanelData& data, ViewerState& state, PanelFields& fields) {
  PanelWishes wishes;
  const ImVec2 size = ImGui::GetIO().DisplaySize;
  ImGui::SetNextWindowPos({0, 0});
  ImGui::SetNextWindowSize({panelWidth(size.x), size.y});
  constexpr ImGuiWindowFlags kFlags = ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoResize |
                                      ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoCollapse |
                                      ImGuiWindowFlags_NoBringToFrontOnFocus;
  if (ImGui::Begin("panel", nullptr, kFlags)) {
    const float footer = ImGui::GetTextLineHeightWithSpacing() + ImGui::GetStyle().ItemSpacing.y;
    if (ImGui::BeginChild("sections", {0, -footer})) drawSections(data, state, fields, wishes);
    ImGui::EndChild();
    ImGui::Spacing();
    ImGui::TextDisabled("F1: keys    Tab: hide this    Ctrl-O: open");
  }
  ImGui::End();
  return wishes;
}

}  // namespace glimt
