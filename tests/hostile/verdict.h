// How glimt may end with any file at all: with a picture, with a picture and warnings, or with exit
// status 3 and one line that says where, what and what to do.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "tests/hostile/limited_run.h"

namespace glimt {

enum class Ending { picture, picture_with_warnings, refused, wrong };

struct Verdict {
  Ending ending = Ending::wrong;
  std::string fault;  // empty unless wrong
  double seconds = 0;
  std::int64_t peak_bytes = 0;
};

// Loads `scene`, and renders a tiny picture of it into `folder` when it loads.
Verdict judge(const std::filesystem::path& scene, const std::filesystem::path& folder);

// Judges a file of any kind: a picture as a scene's sky, materials with a model that uses them,
// anything else as the scene itself.
Verdict judgeFile(const std::filesystem::path& file, const std::filesystem::path& folder);

// What is wrong with a run that had to fail with `status` and one line; empty when nothing is.
std::string faultOfRefusal(const RunResult& run, int status);

// How the files of one group ended.
class Tally {
 public:
  explicit Tally(std::string group) : group_(std::move(group)) {}

  void add(const std::string& name, const Verdict& verdict);
  std::size_t files() const { return files_; }
  // One line for each file that ended as none may.
  const std::vector<std::string>& faults() const { return faults_; }
  // Prints the counts; appends them as a row of fields with tabs between to the file that
  // GLIMT_HOSTILE_REPORT names.
  void report() const;

 private:
  std::string group_;
  std::size_t files_ = 0;
  std::size_t counts_[4] = {};
  double slowest_ = 0;
  std::int64_t largest_ = 0;
  std::vector<std::string> faults_;
};

}  // namespace glimt
