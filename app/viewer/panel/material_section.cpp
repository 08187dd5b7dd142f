#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <cmath>

#include "app/viewer/panel/panel.h"
#include "renderer/core/wording.h"

namespace glimt {
namespace {

std::string nameOf(const Material& material, std::size_t index) {
  return material.name.empty() ? fmt::format("material {}", index + 1) : printable(material.name);
}

// The colour buttons hold what a display shows; the material's colours are linear.
bool editColor(const char* name, Vec3& color) {
  const auto encoded = [](float v) { return std::pow(std::max(v, 0.0f), 1 / 2.2f); };
  Vec3 shown(encoded(color.r), encoded(color.g), encoded(color.b));
  if (!ImGui::ColorEdit3(name, &shown.x, ImGuiColorEditFlags_NoInputs)) return false;
  const auto linear = [](float v) { return std::clamp(std::pow(v, 2.2f), 0.0f, 1.0f); };
  color = Vec3(linear(shown.r), linear(shown.g), linear(shown.b));
  return true;
}

bool editShare(const char* name, float& share) {
  return ImGui::SliderFloat(name, &share, 0, 1, "%.2f", ImGuiSliderFlags_AlwaysClamp);
}

// A colour and how bright it is.
void editEmission(Vec3& emission) {
  float strength = std::max({emission.r, emission.g, emission.b});
  Vec3 color = strength > 0 ? emission / strength : Vec3(1);
  const bool brighter = ImGui::SliderFloat(named("##emission"), &strength, 0, 100, "%.2f",
                                           ImGuiSliderFlags_Logarithmic);
  const bool colored = strength > 0 && editColor(named("##emission colour"), color);
  if (brighter || colored) emission = strength * color;
}

void editGloss(Material& material) {
  bool changed = editShare(named("##metallic"), material.metallic);
  changed |= editShare(named("##roughness"), material.roughness);
  changed |= editShare(named("##transmission"), material.transmission);
  changed |= ImGui::SliderFloat(named("##ior"), &material.ior, 1, 3, "%.3f");
  // A surface of Lambert's kind, which reflects nothing, is made one that does; as in scene files.
  if (changed) material.specular = 1;
}

void drawChoice(ViewerState& state) {
  const std::vector<Material>& materials = state.look.materials;
  const std::string shown =
      state.material ? nameOf(materials[*state.material], *state.material) : "none";
  if (!ImGui::BeginCombo(named("##selected"), shown.c_str())) return;
  for (std::size_t i = 0; i < materials.size(); ++i) {
    ImGui::PushID(static_cast<int>(i));
    if (ImGui::Selectable(nameOf(materials[i], i).c_str(), state.material == i)) state.material = i;
    ImGui::PopID();
  }
  ImGui::EndCombo();
}

}  // namespace

void drawMaterialSection(const PanelData& data, ViewerState& state) {
  drawChoice(state);
  if (!state.material) {
    ImGui::TextDisabled("click a surface to change its material");
    return;
  }
  const Material& original = data.scene->scene.materials[*state.material];
  Material& material = state.look.materials[*state.material];
  editColor(named("##colour"), material.base_color);
  if (material.base_color_texture.used()) {
    ImGui::SameLine();
    ImGui::AlignTextToFramePadding();
    ImGui::TextDisabled("times its texture");
  }
  editGloss(material);
  editShare(named("##clearcoat"), material.clearcoat);
  if (material.clearcoat > 0) editShare(named("##coat roughness"), material.clearcoat_roughness);
  editColor(named("##sheen"), material.sheen_color);
  if (material.sheen_color != Vec3(0))
    editShare(named("##sheen roughness"), material.sheen_roughness);
  editEmission(material.emission);
  if (material != original && ImGui::Button("As in the file")) material = original;
}

}  // namespace glimt
