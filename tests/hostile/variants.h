// Damaged copies of good files, the same ones for the same seed.
#pragma once

#include <random>
#include <string>
#include <string_view>

namespace glimt {

using Randomness = std::mt19937;

// Cut short, with bits flipped, bytes overwritten, a stretch removed, repeated or moved, or numbers
// made extreme: one to four of these.
std::string damaged(std::string_view bytes, Randomness& randomness);

}  // namespace glimt
