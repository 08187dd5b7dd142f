#include "app/interrupt.h"

#include <csignal>

namespace glimt {
namespace {

volatile std::sig_atomic_t signalled = 0;

void restoreDefaults() {
  std::signal(SIGINT, SIG_DFL);
  std::signal(SIGTERM, SIG_DFL);
}

void onSignal(int) {
  signalled = 1;
  restoreDefaults();
}

void catchSignals() {
  signalled = 0;
  struct sigaction action {};
  action.sa_handler = onSignal;
  action.sa_flags = SA_RESTART;  // a file that is being read is read on
  sigemptyset(&action.sa_mask);
  sigaction(SIGINT, &action, nullptr);
  sigaction(SIGTERM, &action, nullptr);
}

}  // namespace

Interrupt::Interrupt() {
  catchSignals();
}

Interrupt::~Interrupt() {
  restoreDefaults();
}

bool Interrupt::requested() const {
  return signalled != 0;
}

void Interrupt::forget() {
  if (requested()) catchSignals();
}

}  // namespace glimt
