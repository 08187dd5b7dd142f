#include <fmt/format.h>
#include <imgui.h>

#include "app/viewer/panel/panel.h"

namespace glimt {

void drawEffectsSection(const PanelData& data) {
  ImGui::PushTextWrapPos(0);
  for (const bool on : {true, false})
    for (const EffectReport& effect : data.effects) {
      if (effect.on != on) continue;
      const std::string line =
          fmt::format("{} {}: {}", on ? "on" : "off", effect.name, effect.reason);
      if (on)
        ImGui::TextUnformatted(line.c_str());
      else
        ImGui::TextDisabled("%s", line.c_str());
    }
  ImGui::PopTextWrapPos();
}

}  // namespace glimt
