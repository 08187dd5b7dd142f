// How far a piece of work is that takes long.
#pragma once

#include <cmath>
#include <functional>

namespace glimt {

// Called with the share of the work that is done, between 0 and 1: it never goes down, and is 1 at
// the end. Always on the thread that asked for the work, which it keeps from working for as long as
// it takes. What it throws ends the work early, and is thrown from there. May be empty.
using WorkProgress = std::function<void(float fraction)>;

// Tells `whole` of a part of its work, the one from `begin` to `end`.
inline WorkProgress partOf(const WorkProgress& whole, float begin, float end) {
  if (!whole) return {};
  return [whole, begin, end](float fraction) { whole(std::lerp(begin, end, fraction)); };
}

}  // namespace glimt
