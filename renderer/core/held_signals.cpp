#include "renderer/core/held_signals.h"

#include <csignal>

namespace glimt {
namespace {

constexpr std::array kSignals{SIGINT, SIGTERM};

std::array<volatile std::sig_atomic_t, kSignals.size()> arrived{};

void hold(int signal) {
  for (std::size_t i = 0; i < kSignals.size(); ++i)
    if (kSignals[i] == signal) arrived[i] = 1;
}

std::mutex& turn() {
  static std::mutex mutex;
  return mutex;
}

}  // namespace

HeldSignals::HeldSignals() : turn_(turn()) {
  struct sigaction action {};
  action.sa_handler = hold;
  action.sa_flags = SA_RESTART;
  sigemptyset(&action.sa_mask);
  for (std::size_t i = 0; i < kSignals.size(); ++i) {
    arrived[i] = 0;
    sigaction(kSignals[i], &action, &before_[i]);
  }
}

HeldSignals::~HeldSignals() {
  for (std::size_t i = 0; i < kSignals.size(); ++i) sigaction(kSignals[i], &before_[i], nullptr);
  for (std::size_t i = 0; i < kSignals.size(); ++i)
    if (arrived[i]) std::raise(kSignals[i]);
}

}  // namespace glimt
