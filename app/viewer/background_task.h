// Work on a thread of its own, beside the window.
#pragma once

#include <atomic>
#include <exception>
#include <functional>
#include <memory>
#include <optional>
#include <thread>
#include <utility>

#include "renderer/core/work_progress.h"

namespace glimt {

// Thrown through the work when it is cancelled.
struct Cancelled {};

template <typename Result>
class BackgroundTask {
 public:
  // `work` tells how far it is, often: that is where it is cancelled. `wake` is called on its
  // thread once it is done.
  using Work = std::function<Result(const WorkProgress& progress)>;
  BackgroundTask(Work work, std::function<void()> wake)
      : thread_([this, work = std::move(work), wake = std::move(wake)] {
          run(work);
          wake();
        }) {}
  BackgroundTask(const BackgroundTask&) = delete;
  BackgroundTask& operator=(const BackgroundTask&) = delete;
  // Cancels, and waits until the work has noticed.
  ~BackgroundTask() {
    cancel();
    thread_.join();
  }

  float progress() const { return progress_; }
  bool done() const { return done_; }
  void cancel() { cancelled_ = true; }
  bool cancelled() const { return cancelled_; }

  // Once it is done. Nothing when it was cancelled. Errors: those of the work.
  std::optional<Result> take() {
    if (error_) std::rethrow_exception(error_);
    return std::move(result_);
  }

 private:
  void run(const Work& work) {
    try {
      result_ = work([this](float fraction) {
        progress_ = fraction;
        if (cancelled_) throw Cancelled();
      });
    } catch (const Cancelled&) {
      result_.reset();
    } catch (...) {
      error_ = std::current_exception();
    }
    done_ = true;
  }

  std::optional<Result> result_;
  std::exception_ptr error_;
  std::atomic<float> progress_ = 0;
  std::atomic<bool> cancelled_ = false;
  std::atomic<bool> done_ = false;
  std::thread thread_;  // last, so that it ends before what it uses
};

}  // namespace glimt
