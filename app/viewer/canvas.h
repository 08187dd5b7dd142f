// The picture in the window, behind the panel.
#pragma once

#include <optional>
#include <utility>

#include "app/viewer/gui.h"
#include "app/viewer/outline.h"
#include "app/viewer/render_thread.h"

namespace glimt {

class Canvas {
 public:
  explicit Canvas(const Gui& gui);

  void take(const PictureFrame& frame);
  void setOutline(const Outline& outline);
  bool hideOutline() { return std::exchange(outlined_, false); }  // whether it was there

  // Between Gui::beginFrame() and endFrame(). From `left`, a share of the window's width, to the
  // right edge; a picture of another shape is centred there, as high as the window. `divider` is
  // the share of that which the picture beside takes, where there is one.
  void draw(float left, float divider) const;

  bool empty() const { return picture_.empty(); }
  bool comparing() const { return comparing_; }

 private:
  GuiTexture picture_;
  GuiTexture beside_;
  GuiTexture outline_;
  float aspect_ = 1;  // of the picture, width / height
  bool comparing_ = false;
  bool outlined_ = false;
};

}  // namespace glimt
