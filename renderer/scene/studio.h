// A photographer's studio, as a picture of all directions.
#pragma once

#include "renderer/core/image.h"

namespace glimt {

// Large soft boxes on dark grey: the key light from the upper right of the front (+z), a weaker one
// from the left, one overhead, and two strips behind that draw edges. A white surface that faces
// the camera of the front is about as bright as a display's white.
Image makeStudio();

}  // namespace glimt
