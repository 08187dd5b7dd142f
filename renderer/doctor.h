// Whether a context renders right pictures: what it claims, and what it really does.
#pragma once

#include <string>
#include <vector>

#include "renderer/renderer.h"

namespace glimt {

enum class Verdict {
  ok,
  warning,  // pictures are right within limits, which the consequence tells
  fatal,    // pictures would be wrong
};

struct Finding {
  std::string name;    // of what was looked at
  std::string result;  // what was measured
  Verdict verdict = Verdict::ok;
  std::string consequence;  // in plain words
};

// Takes seconds on a rasteriser in software. The context is current. A probe that cannot run is a
// finding too: no errors.
std::vector<Finding> examine(ContextHandle& context);

// Whether none of them is fatal.
bool isUsable(const std::vector<Finding>& findings);

std::string nameOf(Verdict verdict);

}  // namespace glimt
