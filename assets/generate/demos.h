// The demo scenes, by name.
#pragma once

#include <functional>
#include <map>
#include <string>

#include "assets/generate/model/demo.h"

namespace glimt::assets {

const std::map<std::string, std::function<Demo()>>& demos();

}  // namespace glimt::assets
