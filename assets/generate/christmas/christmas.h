// A decorated tree in a warm room, and dusk behind the window.
#pragma once

#include "assets/generate/model/demo.h"

namespace glimt::assets {

Demo makeChristmas();

}  // namespace glimt::assets
