// The same work in several processes: software drivers keep one lock a process, so threads would
// wait for each other.
#pragma once

#include <sys/wait.h>
#include <unistd.h>

#include <cstdio>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

namespace glimt {

// What `work(k, file)` wrote in a process of its own, for each k below `count`: read from the
// start. Throws std::runtime_error where one of them failed.
template <class Work>
std::vector<std::shared_ptr<std::FILE>> inProcesses(int count, const Work& work) {
  std::vector<std::shared_ptr<std::FILE>> files;
  std::vector<pid_t> children;
  for (int k = 0; k < count; ++k) {
    std::FILE* const file = std::tmpfile();
    if (!file) throw std::runtime_error("cannot make a temporary file");
    files.emplace_back(file, std::fclose);
    const pid_t child = fork();
    if (child < 0) throw std::runtime_error("cannot start a process");
    if (child == 0) {
      work(k, file);
      _exit(std::fflush(file) == 0 ? 0 : 1);
    }
    children.push_back(child);
  }
  bool whole = true;
  for (const pid_t child : children) {
    int status = 0;
    whole = waitpid(child, &status, 0) == child && status == 0 && whole;
  }
  if (!whole) throw std::runtime_error("a process ended before its work did");
  for (const auto& file : files) std::rewind(file.get());
  return files;
}

}  // namespace glimt
