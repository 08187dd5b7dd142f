#include "tests/hostile/limited_run.h"

#include <fcntl.h>
#include <signal.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <memory>
#include <stdexcept>
#include <thread>

namespace glimt {
namespace {

using Clock = std::chrono::steady_clock;

struct Close {
  void operator()(std::FILE* file) const { std::fclose(file); }
};

std::vector<char*> pointersTo(std::vector<std::string>& words) {
  std::vector<char*> pointers;
  for (std::string& word : words) pointers.push_back(word.data());
  pointers.push_back(nullptr);
  return pointers;
}

std::vector<std::string> environmentWith(const std::vector<std::string>& settings) {
  std::vector<std::string> all = settings;
  for (char** entry = environ; *entry != nullptr; ++entry) all.emplace_back(*entry);
  return all;
}

// In the child: only what is allowed between fork and exec.
[[noreturn]] void become(char* const* command, char* const* environment, const RunLimits& limits,
                         int error_file) {
  const int nowhere = open("/dev/null", O_RDWR);
  dup2(nowhere, STDIN_FILENO);
  dup2(nowhere, STDOUT_FILENO);
  dup2(error_file, STDERR_FILENO);
  const auto seconds = static_cast<rlim_t>(limits.seconds);
  const rlimit computing{seconds, seconds + 1};
  setrlimit(RLIMIT_CPU, &computing);
  if (limits.file_bytes >= 0) {
    const auto bytes = static_cast<rlim_t>(limits.file_bytes);
    const rlimit limit{bytes, bytes};
    setrlimit(RLIMIT_FSIZE, &limit);
  }
  execve(command[0], command, environment);
  _exit(127);
}

double secondsOf(const timeval& time) {
  return static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec);
}

std::vector<std::string> linesOf(std::FILE* file) {
  std::rewind(file);
  std::vector<std::string> lines;
  std::string line;
  for (int c = std::fgetc(file); c != EOF; c = std::fgetc(file)) {
    if (c != '\n') {
      line += static_cast<char>(c);
      continue;
    }
    lines.push_back(line);
    line.clear();
  }
  if (!line.empty()) lines.push_back(line);
  return lines;
}

}  // namespace

RunResult runLimited(const std::vector<std::string>& command, const RunLimits& limits,
                     const std::vector<std::string>& environment) {
  const std::unique_ptr<std::FILE, Close> errors(std::tmpfile());
  if (!errors) throw std::runtime_error("cannot make a temporary file");
  std::vector<std::string> words = command;
  std::vector<std::string> settings = environmentWith(environment);
  const std::vector<char*> word_pointers = pointersTo(words);
  const std::vector<char*> setting_pointers = pointersTo(settings);
  const Clock::time_point start = Clock::now();
  const pid_t child = fork();
  if (child < 0) throw std::runtime_error("cannot start another process");
  if (child == 0) {
    become(word_pointers.data(), setting_pointers.data(), limits, fileno(errors.get()));
  }

  RunResult result;
  int status = 0;
  rusage usage{};
  while (wait4(child, &status, WNOHANG, &usage) == 0) {
    if (!result.out_of_time && Clock::now() - start > std::chrono::seconds(10 * limits.seconds)) {
      result.out_of_time = true;
      kill(child, SIGKILL);
    }
    std::this_thread::sleep_for(std::chrono::milliseconds(2));
  }
  result.seconds = secondsOf(usage.ru_utime) + secondsOf(usage.ru_stime);
  result.peak_bytes = std::int64_t{1024} * usage.ru_maxrss;
  if (WIFEXITED(status)) result.status = WEXITSTATUS(status);
  if (WIFSIGNALED(status)) result.signal = WTERMSIG(status);
  result.out_of_time = result.out_of_time || result.signal == SIGXCPU;
  result.lines = linesOf(errors.get());
  return result;
}

}  // namespace glimt
