// What glimt bench --suite device found, for people and for programs.
#pragma once

#include <string>

#include "app/json_output.h"
#include "renderer/bench.h"

namespace glimt {

// A table of the device's own rates; one of what each traversal's rays take beside them; and for
// each of these a sentence that says how near it comes.
std::string textOf(const DeviceBench& bench, const ContextInfo& context);

Json jsonOf(const DeviceBench& bench, const ContextInfo& context);

}  // namespace glimt
