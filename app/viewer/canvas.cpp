#include "app/viewer/canvas.h"

namespace glimt {
namespace {

constexpr ImU32 kDivider = IM_COL32(255, 255, 255, 200);
constexpr ImU32 kWhite = IM_COL32_WHITE;

void drawPart(ImDrawList& list, const GuiTexture& texture, float from, float to) {
  const ImVec2 size = ImGui::GetIO().DisplaySize;
  list.AddImage(texture.id(), {from * size.x, 0}, {to * size.x, size.y}, {from, 0}, {to, 1},
                kWhite);
}

}  // namespace

Canvas::Canvas(const Gui& gui)
    : picture_(gui.makeTexture()), beside_(gui.makeTexture()), outline_(gui.makeTexture()) {}

void Canvas::take(const PictureFrame& frame) {
  picture_.set(frame.image);
  comparing_ = !frame.beside.bytes.empty();
  if (comparing_) beside_.set(frame.beside);
}

void Canvas::setOutline(const Outline& outline) {
  outline_.set(outline.width, outline.height, outline.rgba.data());
  outlined_ = true;
}

void Canvas::draw(float divider) const {
  if (picture_.empty()) return;
  ImDrawList& list = *ImGui::GetBackgroundDrawList();
  const ImVec2 size = ImGui::GetIO().DisplaySize;
  const float split = comparing_ ? divider : 0;
  if (comparing_) drawPart(list, beside_, 0, split);
  drawPart(list, picture_, split, 1);
  if (outlined_) drawPart(list, outline_, split, 1);
  if (!comparing_) return;
  const float x = divider * size.x;
  list.AddLine({x, 0}, {x, size.y}, kDivider, 2);
  list.AddCircleFilled({x, 0.5f * size.y}, 7, kDivider);
}

}  // namespace glimt
