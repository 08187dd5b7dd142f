// A program run with a limit of time, and what it left behind.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace glimt {

struct RunLimits {
  int seconds = 20;              // of computing; ten times as many may pass, on a busy machine
  std::int64_t file_bytes = -1;  // largest file that may be written; negative: any
};

struct RunResult {
  int status = -1;  // of the exit; -1 when a signal ended it
  int signal = 0;
  bool out_of_time = false;
  double seconds = 0;              // of computing, on all cores together
  std::int64_t peak_bytes = 0;     // largest resident memory
  std::vector<std::string> lines;  // of standard error
};

// Standard output goes nowhere. `environment` holds settings "NAME=VALUE" besides those there are.
RunResult runLimited(const std::vector<std::string>& command, const RunLimits& limits,
                     const std::vector<std::string>& environment = {});

}  // namespace glimt
