#pragma once

#include "assets/generate/geometry/mesh.h"

namespace glimt::assets::motorcycle {

// About +y. `radius` is that of the tread's middle, `bead` where the tyre meets the rim.
Mesh tyre(double radius, double bead, double width, int steps_around);

}  // namespace glimt::assets::motorcycle
