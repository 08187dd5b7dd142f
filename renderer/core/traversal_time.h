// How long a sample takes with a traversal.
#pragma once

#include <string>

namespace glimt {

struct TraversalTime {
  std::string traversal;
  double seconds_per_sample = 0;
};

}  // namespace glimt
