// Choosing among many by their weights in constant time: Vose 1991, "A Linear Algorithm for
// Generating Random Numbers with a Given Distribution".
#pragma once

#include <cstdint>
#include <vector>

namespace glimt {

// To choose with u in [0, 1), take entry i = floor(u * size); of it i itself where the fraction of
// u * size is below `share`, else `other`.
struct AliasEntry {
  float share = 1;
  std::uint32_t other = 0;
};

// Entries in proportion to their weights, which are not negative and not all zero.
std::vector<AliasEntry> buildAliasTable(const std::vector<double>& weights);

}  // namespace glimt
