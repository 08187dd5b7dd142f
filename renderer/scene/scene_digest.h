#pragma once

#include <string>

#include "renderer/scene/scene.h"

namespace glimt {

// A SHA-256 of all in a scene that its picture depends on, the camera included: two scenes with the
// same one look the same. Names, warnings, other cameras and RenderDefaults are left out.
std::string digestOf(const Scene& scene);

}  // namespace glimt
