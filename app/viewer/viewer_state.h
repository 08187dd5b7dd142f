// What the window shows and how, as a plain value that the panel edits.
#pragma once

#include <optional>

#include "app/viewer/look.h"

namespace glimt {

struct ViewerState {
  Look look;
  float noise_goal = 0.02f;  // a share of 1
  bool denoise = false;
  std::optional<std::size_t> material;  // that is selected, into Look::materials
  bool panel = true;
  bool help = false;
  bool turntable = false;
  float divider = 0.5f;  // share of the width left of it, where two are compared
};

}  // namespace glimt
