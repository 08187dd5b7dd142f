// Files that others found to be awkward or to bring down loaders.
#include <algorithm>
#include <catch2/catch.hpp>
#include <iostream>
#include <map>

#include "tests/hostile/verdict.h"
#include "tests/unit/temporary_folder.h"

using namespace glimt;
namespace fs = std::filesystem;

namespace {

std::vector<fs::path> filesIn(const fs::path& folder) {
  std::vector<fs::path> files;
  for (const fs::directory_entry& entry : fs::recursive_directory_iterator(folder)) {
    if (entry.is_regular_file()) files.push_back(entry.path());
  }
  std::sort(files.begin(), files.end());
  return files;
}

// A row for each folder below `folder`.
void judgeAllIn(const fs::path& folder) {
  if (!fs::exists(folder)) {
    std::cout << "skipped: " << folder.string() << " is not there\n";
    return;
  }
  const TemporaryFolder temporary;
  std::map<std::string, Tally> tallies;
  for (const fs::path& file : filesIn(folder)) {
    const fs::path below = fs::relative(file, folder);
    const std::string group = (folder.filename() / *below.begin()).string();
    Tally& tally = tallies.try_emplace(group, group).first->second;
    tally.add(below.string(), judgeFile(file, temporary / ""));
  }
  for (const auto& [group, tally] : tallies) {
    tally.report();
    for (const std::string& fault : tally.faults()) FAIL_CHECK(fault);
  }
}

const fs::path kModels = fs::path(GLIMT_SHARED_DIR) / "models";

}  // namespace

TEST_CASE("every file that is hostile ends in a picture or a refusal") {
  judgeAllIn(kModels / "hostile");
}

TEST_CASE("every awkward OBJ and MTL file ends in a picture or a refusal") {
  judgeAllIn(kModels / "obj-cases");
}
