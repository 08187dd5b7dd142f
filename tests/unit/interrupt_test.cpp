#include "app/interrupt.h"

#include <sys/wait.h>
#include <unistd.h>

#include <catch2/catch.hpp>
#include <chrono>
#include <csignal>
#include <functional>
#include <thread>

using namespace glimt;

namespace {

constexpr std::chrono::milliseconds kLater{350};

// In a process of its own, as it may end by a signal: how it does.
int statusOf(const std::function<bool()>& holds) {
  const pid_t child = fork();
  if (child == 0) _exit(holds() ? 0 : 1);
  int status = -1;
  waitpid(child, &status, 0);
  return status;
}

bool endsBy(int signal, const std::function<bool()>& what) {
  const int status = statusOf(what);
  return WIFSIGNALED(status) && WTERMSIG(status) == signal;
}

}  // namespace

TEST_CASE("a signal is a request, also if it is sent twice at once") {
  for (const int signal : {SIGINT, SIGTERM}) {
    CAPTURE(signal);
    CHECK(statusOf([signal] {
            const Interrupt interrupt;
            const bool before = interrupt.requested();
            std::raise(signal);
            std::raise(signal);
            return !before && interrupt.requested();
          }) == 0);
  }
}

TEST_CASE("what was requested may be sent once more while the program ends") {
  CHECK(statusOf([] {
          {
            const Interrupt interrupt;
            std::raise(SIGTERM);
          }
          std::raise(SIGTERM);
          return true;
        }) == 0);
}

TEST_CASE("a second signal that comes later kills") {
  CHECK(endsBy(SIGINT, [] {
    const Interrupt interrupt;
    std::raise(SIGINT);
    std::this_thread::sleep_for(kLater);
    std::raise(SIGINT);
    return true;
  }));
}

TEST_CASE("a request that is forgotten can be made again") {
  CHECK(statusOf([] {
          Interrupt interrupt;
          std::raise(SIGINT);
          interrupt.forget();
          const bool forgotten = !interrupt.requested();
          std::this_thread::sleep_for(kLater);
          std::raise(SIGINT);
          return forgotten && interrupt.requested();
        }) == 0);
}

TEST_CASE("without a request signals kill again afterwards") {
  CHECK(endsBy(SIGTERM, [] {
    { const Interrupt interrupt; }
    std::raise(SIGTERM);
    return true;
  }));
}
