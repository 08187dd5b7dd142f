// A twin of the sixties' kind.
#pragma once

#include "assets/generate/model/demo.h"

namespace glimt::assets {

// Photographed in a studio.
Demo makeMotorcycle();

// Cut out, with nothing but its shadow on the floor: from all around, in four variants.
Demo makeShopMotorcycle();

}  // namespace glimt::assets
