// What glimt bench found, for people and for programs.
#pragma once

#include <string>
#include <vector>

#include "app/bench_conditions.h"
#include "app/json_output.h"
#include "renderer/bench.h"

namespace glimt {

// A table: for each way to cast the rays its rates, the median and in brackets the least and most.
std::string textOf(const std::vector<TraversalRow>& rows, const BenchConditions& conditions);

// A table: for each way to trace the bounces the seconds that a sample takes.
std::string textOf(const std::vector<PassesRow>& rows, const BenchConditions& conditions);

// A table: for each effect that is withheld or forced the seconds that a sample takes, and how
// many times those of the scene's own effects.
std::string textOf(const std::vector<EffectsRow>& rows, const BenchConditions& conditions);

Json jsonOf(const std::vector<TraversalRow>& rows, const BenchConditions& conditions);
Json jsonOf(const std::vector<PassesRow>& rows, const BenchConditions& conditions);
Json jsonOf(const std::vector<EffectsRow>& rows, const BenchConditions& conditions);

}  // namespace glimt
