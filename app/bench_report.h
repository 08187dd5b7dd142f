// What glimt bench found, for people and for programs.
#pragma once

#include <string>
#include <vector>

#include "app/json_output.h"
#include "renderer/bench.h"

namespace glimt {

// A table: for each way to cast the rays its rates, the median and in brackets the least and most.
std::string textOf(const std::vector<TraversalRow>& rows, const ContextInfo& context);

Json jsonOf(const std::vector<TraversalRow>& rows, const ContextInfo& context);

}  // namespace glimt
