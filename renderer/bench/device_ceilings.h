// The rates of everything that a traversal is made of.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "renderer/bench.h"
#include "renderer/gl/device.h"

namespace glimt {

// Each kind of work in pictures of each of the sides, and chains of fetches in one pixel alone,
// which tell how long a fetch takes. `progress` is told what is being done. Errors: failed.
std::vector<DeviceRow> measureCeilings(const gl::Device& device,
                                       const DeviceBenchSettings& settings,
                                       const std::function<void(const std::string&)>& progress);

}  // namespace glimt
