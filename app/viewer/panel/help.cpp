#include <imgui.h>

#include <array>
#include <utility>

#include "app/viewer/panel/panel.h"

namespace glimt {
namespace {

constexpr std::array<std::pair<const char*, const char*>, 20> kKeys{{
    {"left drag", "turn around the target"},
    {"right or middle drag, Ctrl-drag", "move sideways"},
    {"Shift-drag", "turn the surroundings"},
    {"wheel", "nearer and farther, towards the pointer"},
    {"click", "select a material"},
    {"double click", "set the target and the focus"},
    {"F", "frame what is selected, or everything"},
    {"R", "back to the start"},
    {"1 to 9", "the file's cameras"},
    {"T or space", "turntable"},
    {"C", "compare: keep this look on the left"},
    {"Ctrl-Z, Ctrl-Y", "undo, redo"},
    {"S", "save the picture as it is"},
    {"Ctrl-S", "save the changes as a scene file"},
    {"Ctrl-C", "copy as a glimt render command line"},
    {"Ctrl-O", "open: type a path, or drop a file on the window"},
    {"Tab", "hide or show the panel"},
    {"arrows, Enter", "move in the panel, and change"},
    {"F1", "these keys"},
    {"Esc", "close this; else end"},
}};

}  // namespace

void drawHelp(bool& shown) {
  const ImVec2 size = ImGui::GetIO().DisplaySize;
  ImGui::SetNextWindowPos({0.5f * size.x, 0.5f * size.y}, ImGuiCond_Always, {0.5f, 0.5f});
  constexpr ImGuiWindowFlags kFlags =
      ImGuiWindowFlags_AlwaysAutoResize | ImGuiWindowFlags_NoCollapse | ImGuiWindowFlags_NoMove;
  if (ImGui::Begin("Keys", &shown, kFlags) &&
      ImGui::BeginTable("keys", 2, ImGuiTableFlags_SizingFixedFit)) {
    for (const auto& [key, what] : kKeys) {
      ImGui::TableNextRow();
      ImGui::TableNextColumn();
      ImGui::TextColored(ImGui::GetStyle().Colors[ImGuiCol_SliderGrab], "%s", key);
      ImGui::TableNextColumn();
      ImGui::TextUnformatted(what);
    }
    ImGui::EndTable();
  }
  ImGui::End();
}

}  // namespace glimt
