// What glimt bench found, as one picture.
#pragma once

#include <string>
#include <vector>

#include "app/bench_conditions.h"
#include "renderer/bench.h"

namespace glimt {

// A self-contained SVG file. Bars for each kind of ray and each traversal, one panel a mesh; Embree
// is the line above them.
std::string chartOf(const std::vector<TraversalRow>& rows, const BenchConditions& conditions);

// Lines over the number of bounces: seconds a sample above, seconds to compile below; one panel a
// scene.
std::string chartOf(const std::vector<PassesRow>& rows, const BenchConditions& conditions);

// Bars for each effect that is withheld or forced: seconds a sample above, seconds to compile
// below.
std::string chartOf(const std::vector<EffectsRow>& rows, const BenchConditions& conditions);

}  // namespace glimt
