#include "app/viewer/canvas.h"

#include <algorithm>

namespace glimt {
namespace {

constexpr ImU32 kDivider = IM_COL32(255, 255, 255, 200);

// Where in the window a picture of that shape is: as high, and centred in its part of it.
struct Place {
  float left = 0;  // of the part that is for the picture
  float right = 1;
  float height = 1;
  float picture_left = 0;
  float picture_width = 1;

  Place(float share_left, float aspect) {
    const ImVec2 size = ImGui::GetIO().DisplaySize;
    left = share_left * size.x;
    right = size.x;
    height = size.y;
    picture_width = aspect * height;
    picture_left = 0.5f * (left + right - picture_width);
  }

  float at(float share) const { return left + share * (right - left); }
};

// What is between two columns of the window.
void drawPart(ImDrawList& list, const GuiTexture& texture, const Place& place, float from,
              float to) {
  const float begin = std::max(from, place.picture_left);
  const float end = std::min(to, place.picture_left + place.picture_width);
  if (begin >= end) return;
  const auto share = [&](float x) { return (x - place.picture_left) / place.picture_width; };
  list.AddImage(texture.id(), {begin, 0}, {end, place.height}, {share(begin), 0}, {share(end), 1});
}

}  // namespace

Canvas::Canvas(const Gui& gui)
    : picture_(gui.makeTexture()), beside_(gui.makeTexture()), outline_(gui.makeTexture()) {}

void Canvas::take(const PictureFrame& frame) {
  picture_.set(frame.image);
  aspect_ = static_cast<float>(frame.size[0]) / static_cast<float>(frame.size[1]);
  comparing_ = !frame.beside.bytes.empty();
  if (comparing_) beside_.set(frame.beside);
}

void Canvas::setOutline(const Outline& outline) {
  outline_.set(outline.width, outline.height, outline.rgba.data());
  outlined_ = true;
}

void Canvas::draw(float left, float divider) const {
  if (picture_.empty()) return;
  ImDrawList& list = *ImGui::GetBackgroundDrawList();
  const Place place(left, aspect_);
  const float split = place.at(comparing_ ? divider : 0);
  if (comparing_) drawPart(list, beside_, place, place.left, split);
  drawPart(list, picture_, place, split, place.right);
  if (outlined_) drawPart(list, outline_, place, split, place.right);
  if (!comparing_) return;
  list.AddLine({split, 0}, {split, place.height}, kDivider, 2);
  list.AddCircleFilled({split, 0.5f * place.height}, 7, kDivider);
}

}  // namespace glimt
