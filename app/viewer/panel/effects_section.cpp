#include <fmt/format.h>
#include <imgui.h>

#include "app/viewer/panel/panel.h"
#include "renderer/core/wording.h"

namespace glimt {
namespace {

// What a busy machine cannot tell from nothing.
constexpr double kHardlyAny = 0.05;

// Of one that is on.
std::string costText(const PanelData& data, const EffectReport& effect) {
  if (!data.effect_costs) return "";
  const auto cost = data.effect_costs->find(effect.name);
  if (cost == data.effect_costs->end()) return "";
  if (cost->second < kHardlyAny) return "; hardly any time";
  return fmt::format("; {} of the time", percent(cost->second));
}

}  // namespace

void drawEffectsSection(const PanelData& data, PanelWishes& wishes) {
  if (data.measuring_effects)
    ImGui::TextDisabled("measuring ...");
  else if (ImGui::Button("Measure what they cost"))
    wishes.measure_effects = true;
  if (ImGui::IsItemHovered())
    ImGui::SetTooltip("draws the scene without each of those that are on");
  ImGui::PushTextWrapPos(0);
  for (const bool on : {true, false})
    for (const EffectReport& effect : data.status.effects) {
      if (effect.on != on) continue;
      const std::string line = fmt::format("{} {}: {}{}", on ? "on" : "off", effect.name,
                                           effect.reason, on ? costText(data, effect) : "");
      if (on)
        ImGui::TextUnformatted(line.c_str());
      else
        ImGui::TextDisabled("%s", line.c_str());
    }
  ImGui::PopTextWrapPos();
}

}  // namespace glimt
