// One line on the terminal that is rewritten in place.
#pragma once

#include <chrono>
#include <cstddef>
#include <string_view>

namespace glimt {

// Shows nothing unless standard error is a terminal. The line is gone when this is destroyed.
class Progress {
 public:
  explicit Progress(bool wanted);
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;
  ~Progress();

  // Replaces the line.
  void show(std::string_view text);

  // True when the last show() is long enough ago for people to have read it.
  bool due() const;

  // Removes the line, so that something else can be printed.
  void clear();

 private:
  void write(std::string_view text);

  bool enabled_;
  std::size_t shown_ = 0;  // bytes of the line on the terminal
  std::chrono::steady_clock::time_point last_;
};

// Shows how far the renderer's tree is, where it takes long enough for people to read, and then
// what follows it.
void showTree(Progress& progress, float fraction);

}  // namespace glimt
