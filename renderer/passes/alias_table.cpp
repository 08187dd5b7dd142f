#include "renderer/passes/alias_table.h"

#include <numeric>

namespace glimt {

// Entries with less than the mean give what they lack to one with more.
std::vector<AliasEntry> buildAliasTable(const std::vector<double>& weights) {
  const double mean =
      std::accumulate(weights.begin(), weights.end(), 0.0) / static_cast<double>(weights.size());
  std::vector<AliasEntry> entries(weights.size());
  std::vector<double> scaled;
  std::vector<std::uint32_t> poor;
  std::vector<std::uint32_t> rich;
  for (std::uint32_t i = 0; i < entries.size(); ++i) {
    scaled.push_back(weights[i] / mean);
    entries[i].other = i;
    (scaled[i] < 1 ? poor : rich).push_back(i);
  }
  while (!poor.empty() && !rich.empty()) {
    const std::uint32_t taker = poor.back();
    const std::uint32_t giver = rich.back();
    poor.pop_back();
    entries[taker].share = static_cast<float>(scaled[taker]);
    entries[taker].other = giver;
    scaled[giver] -= 1 - scaled[taker];
    if (scaled[giver] < 1) {
      rich.pop_back();
      poor.push_back(giver);
    }
  }
  // What is left differs from one by rounding only, and keeps a share of one.
  return entries;
}

}  // namespace glimt
