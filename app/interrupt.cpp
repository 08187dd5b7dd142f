#include "app/interrupt.h"

#include <atomic>
#include <chrono>
#include <csignal>

namespace glimt {
namespace {

using Clock = std::chrono::steady_clock;
using Ticks = std::atomic<Clock::rep>;
static_assert(Ticks::is_always_lock_free, "a handler of signals may use it");

// timeout signals its child and then the child's whole group, some schedulers the process and its
// step: microseconds apart, or some milliseconds on a busy machine.
constexpr Clock::duration kOneRequest = std::chrono::milliseconds(300);

volatile std::sig_atomic_t signalled = 0;
Ticks requested_at = 0;

void restoreDefaults() {
  std::signal(SIGINT, SIG_DFL);
  std::signal(SIGTERM, SIG_DFL);
}

void onSignal(int signal) {
  const Clock::rep now = Clock::now().time_since_epoch().count();
  Clock::rep before = requested_at.load();
  if (before != 0 && now - before < kOneRequest.count()) return;
  if (!requested_at.compare_exchange_strong(before, now)) return;  // another thread has it
  if (signalled != 0) {
    restoreDefaults();
    std::raise(signal);  // it comes when the handler is left
  }
  signalled = 1;
}

void catchSignals() {
  signalled = 0;
  struct sigaction action {};
  action.sa_handler = onSignal;
  action.sa_flags = SA_RESTART;  // a file that is being read is read on
  sigemptyset(&action.sa_mask);
  sigaddset(&action.sa_mask, SIGINT);
  sigaddset(&action.sa_mask, SIGTERM);
  sigaction(SIGINT, &action, nullptr);
  sigaction(SIGTERM, &action, nullptr);
}

}  // namespace

Interrupt::Interrupt() {
  catchSignals();
}

// What has been requested may be sent once more while the program ends.
Interrupt::~Interrupt() {
  if (!requested()) restoreDefaults();
}

bool Interrupt::requested() const {
  return signalled != 0;
}

void Interrupt::forget() {
  signalled = 0;
}

}  // namespace glimt
