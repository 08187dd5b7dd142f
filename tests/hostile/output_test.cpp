// Outputs that cannot be written: exit status 1 (2 where it shows before anything is rendered), one
// line, and no half of a picture.
#include <catch2/catch.hpp>

#include "tests/hostile/verdict.h"
#include "tests/unit/temporary_folder.h"

using namespace glimt;
namespace fs = std::filesystem;

namespace {

fs::path sceneIn(const TemporaryFolder& folder) {
  return folder.write("x.scene.json", R"({"model": "x.obj", "environment": {"strength": 1}})");
}

class Outputs {
 public:
  Outputs() { folder_.write("x.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n"); }

  RunResult render(const std::vector<std::string>& outputs, std::int64_t file_bytes = -1) const {
    std::vector<std::string> command = {GLIMT_PROGRAM, "render", sceneIn(folder_).string(),
                                        "--size",      "64x64",  "--spp",
                                        "1",           "--quiet"};
    command.insert(command.end(), outputs.begin(), outputs.end());
    RunLimits limits;
    limits.file_bytes = file_bytes;
    return runLimited(command, limits, {"ASAN_OPTIONS=detect_leaks=0"});
  }

  const TemporaryFolder& folder() const { return folder_; }

 private:
  TemporaryFolder folder_;
};

}  // namespace

TEST_CASE("a full disk is told in one line, for pictures of all formats and reports") {
  const Outputs outputs;
  for (const char* name : {"full.png", "full.exr", "full.pfm", "full.hdr"}) {
    CAPTURE(name);
    const fs::path link = outputs.folder() / name;
    fs::create_symlink("/dev/full", link);
    CHECK(faultOfRefusal(outputs.render({"-o", link.string()}), 1) == "");
  }
  const std::string good = (outputs.folder() / "good.png").string();
  CHECK(faultOfRefusal(outputs.render({"-o", good, "--json", "/dev/full"}), 1) == "");
}

TEST_CASE("a file that may not grow is told in one line, and nothing of it is left") {
  const Outputs outputs;
  const fs::path picture = outputs.folder() / "large.pfm";
  const std::size_t before =
      (outputs.render({"-o", (outputs.folder() / "x.png").string()}), outputs.folder().fileCount());
  CHECK(faultOfRefusal(outputs.render({"-o", picture.string()}, 8192), 1) == "");
  CHECK_FALSE(fs::exists(picture));
  CHECK(outputs.folder().fileCount() == before);
}

TEST_CASE("one output that fails does not keep the other from being written") {
  const Outputs outputs;
  const fs::path link = outputs.folder() / "full.exr";
  fs::create_symlink("/dev/full", link);
  const fs::path good = outputs.folder() / "good.png";
  CHECK(faultOfRefusal(outputs.render({"-o", link.string(), "-o", good.string()}), 1) == "");
  CHECK(fs::file_size(good) > 0);
}

TEST_CASE("an output that is a folder, or in none, is refused before anything is rendered") {
  const Outputs outputs;
  const fs::path folder = outputs.folder() / "folder.png";
  fs::create_directory(folder);
  CHECK(faultOfRefusal(outputs.render({"-o", folder.string()}), 2) == "");
  CHECK(faultOfRefusal(outputs.render({"-o", (folder / "none/x.png").string()}), 2) == "");
}
