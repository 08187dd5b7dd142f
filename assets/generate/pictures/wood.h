#pragma once

#include <string>

#include "assets/generate/model/model.h"

namespace glimt::assets {

// A tile of oak, its grain along v: half as wide as it is long, `length` pixels.
Picture woodGrain(const std::string& name, int length);

}  // namespace glimt::assets
