#include "renderer/bvh/parallel_for.h"

#include <algorithm>
#include <atomic>
#include <exception>
#include <mutex>
#include <system_error>
#include <thread>
#include <vector>

namespace glimt {
namespace {

class Work {
 public:
  Work(std::size_t count, const std::function<void(std::size_t)>& body)
      : count_(count), body_(body) {}

  // What each thread does: takes the next index until none is left.
  void run() noexcept {
    try {
      for (std::size_t i = next_++; i < count_; i = next_++) body_(i);
    } catch (...) {
      next_ = count_;
      const std::scoped_lock lock(mutex_);
      if (!failure_) failure_ = std::current_exception();
    }
  }
  void rethrowFailure() const {
    if (failure_) std::rethrow_exception(failure_);
  }

 private:
  const std::size_t count_;
  const std::function<void(std::size_t)>& body_;
  std::atomic<std::size_t> next_ = 0;
  std::mutex mutex_;
  std::exception_ptr failure_;
};

}  // namespace

void parallelFor(unsigned threads, std::size_t count,
                 const std::function<void(std::size_t)>& body) {
  Work work(count, body);
  std::vector<std::thread> others;
  const std::size_t all = std::min<std::size_t>(threads, count);
  try {
    others.reserve(all);
    while (others.size() + 1 < all) others.emplace_back([&work] { work.run(); });
  } catch (const std::system_error&) {
    // Those that there are do it all.
  }
  work.run();
  for (std::thread& other : others) other.join();
  work.rethrowFailure();
}

}  // namespace glimt
