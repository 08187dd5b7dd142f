// What loadScene promises of every scene.
#pragma once

#include <string>

#include "renderer/scene/scene.h"

namespace glimt {

// The first promise that the scene breaks; empty when it keeps them all.
std::string flawOf(const Scene& scene);

}  // namespace glimt
