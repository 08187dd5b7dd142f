// Ctrl-C and SIGTERM as a request that is answered when it suits.
#pragma once

namespace glimt {

// While one exists, the first SIGINT or SIGTERM only sets requested(); the second kills, as it
// would without. Signals within 0.3 s are one: what ends a process (timeout, schedulers) may send
// several. At most one exists at a time.
class Interrupt {
 public:
  Interrupt();
  Interrupt(const Interrupt&) = delete;
  Interrupt& operator=(const Interrupt&) = delete;
  ~Interrupt();

  bool requested() const;

  // What was requested is done: the next signal is a request again.
  void forget();
};

}  // namespace glimt
