// A wristwatch on a cushion: the product that a shop offers in several finishes.
#pragma once

#include "assets/generate/model/demo.h"

namespace glimt::assets {

Demo makeWatch();

}  // namespace glimt::assets
