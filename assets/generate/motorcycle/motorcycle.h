// A twin of the sixties' kind, photographed in a studio.
#pragma once

#include "assets/generate/model/demo.h"

namespace glimt::assets {

Demo makeMotorcycle();

}  // namespace glimt::assets
