#pragma once

#include "renderer/core/context_info.h"

namespace glimt {

// Under which glimt bench measured.
struct BenchConditions {
  ContextInfo context;
  int side = 512;  // of the square of rays or pixels
};

}  // namespace glimt
