// A stretch of work that Ctrl-C and SIGTERM cannot cut in two.
#pragma once

#include <signal.h>

#include <array>
#include <mutex>

namespace glimt {

// While one exists, SIGINT and SIGTERM wait, for the whole process: a driver's threads may take
// them too. Those that have come do what they would have done once it is gone. Of several threads
// that want one, each waits for its turn.
class HeldSignals {
 public:
  HeldSignals();
  HeldSignals(const HeldSignals&) = delete;
  HeldSignals& operator=(const HeldSignals&) = delete;
  ~HeldSignals();

 private:
  std::unique_lock<std::mutex> turn_;
  std::array<struct sigaction, 2> before_{};
};

}  // namespace glimt
