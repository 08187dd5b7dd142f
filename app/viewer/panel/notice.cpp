#include <imgui.h>

#include <algorithm>

#include "app/viewer/panel/panel.h"
#include "renderer/core/wording.h"

namespace glimt {
namespace {

void drawMessage(const NoticeData& notice, float width) {
  ImGui::PushTextWrapPos(std::max(width, 80.0f));
  if (notice.failure) ImGui::PushStyleColor(ImGuiCol_Text, {1, 0.55f, 0.45f, 1});
  ImGui::TextUnformatted(notice.message.c_str());
  if (notice.failure) ImGui::PopStyleColor();
  ImGui::PopTextWrapPos();
}

bool drawLoading(const NoticeData& notice) {
  ImGui::Text("loading %s", printable(notice.loading).c_str());
  ImGui::ProgressBar(notice.progress, {14 * ImGui::GetFontSize(), 0});
  if (!notice.can_cancel) return false;
  ImGui::SameLine();
  return ImGui::Button("Cancel");
}

}  // namespace

bool drawNotice(const NoticeData& notice) {
  const bool loading = !notice.loading.empty();
  if (notice.message.empty() && !loading && notice.preparing.empty()) return false;
  const ImVec2 size = ImGui::GetIO().DisplaySize;
  const float left = notice.left * size.x;
  ImGui::SetNextWindowPos({0.5f * (left + size.x), size.y - 12}, ImGuiCond_Always, {0.5f, 1});
  ImGui::SetNextWindowSizeConstraints({0, 0}, {std::max(size.x - left - 24, 100.0f), size.y});
  ImGuiWindowFlags flags = ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_AlwaysAutoResize |
                           ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoFocusOnAppearing |
                           ImGuiWindowFlags_NoNav;
  // What can only be read does not keep the mouse from the picture.
  if (!loading) flags |= ImGuiWindowFlags_NoInputs;
  bool cancel = false;
  ImGui::PushStyleVar(ImGuiStyleVar_WindowBorderSize, 1);
  if (ImGui::Begin("notice", nullptr, flags)) {
    if (!notice.message.empty()) drawMessage(notice, size.x - left - 60);
    if (loading)
      cancel = drawLoading(notice);
    else if (!notice.preparing.empty())
      ImGui::Text("preparing %s", notice.preparing.c_str());
  }
  ImGui::End();
  ImGui::PopStyleVar();
  return cancel;
}

}  // namespace glimt
