// Damaged copies of small good files.
#include <catch2/catch.hpp>

#include "tests/hostile/good_files.h"
#include "tests/hostile/variants.h"
#include "tests/hostile/verdict.h"
#include "tests/unit/temporary_folder.h"

using namespace glimt;
namespace fs = std::filesystem;

namespace {

constexpr std::uint32_t kSeed = 20130607;

// An OBJ with its materials, a scene with its model: so that all of a file matters.
void writeCompanions(const TemporaryFolder& folder) {
  for (const GoodFile& file : goodFiles()) {
    if (file.name == "colors.mtl") folder.write("box.mtl", file.bytes);
  }
  folder.write("scene.obj", "usemtl a\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
}

void judgeVariants(const std::string& kind, int count) {
  const TemporaryFolder folder;
  writeCompanions(folder);
  const std::string extension = kind == "json" ? "scene.json" : kind;
  Tally tally("damaged " + kind);
  for (const GoodFile& file : goodFiles()) {
    if (file.kind != kind) continue;
    Randomness randomness(kSeed);
    for (int i = 0; i < count; ++i) {
      const std::string bytes = damaged(file.bytes, randomness);
      const fs::path path = folder.write("variant." + extension, bytes);
      const Verdict verdict = judgeFile(path, folder / "");
      const std::string name = file.name + " number " + std::to_string(i);
      tally.add(name, verdict);
    }
  }
  tally.report();
  for (const std::string& fault : tally.faults()) FAIL_CHECK(fault);
}

void judgeAllKinds(int count) {
  for (const char* kind : {"exr", "glb", "gltf", "hdr", "json", "mtl", "obj", "pfm", "png"}) {
    judgeVariants(kind, count);
  }
}

}  // namespace

TEST_CASE("good files end in a picture") {
  const TemporaryFolder folder;
  writeCompanions(folder);
  for (const GoodFile& file : goodFiles()) {
    CAPTURE(file.name);
    const Verdict verdict = judgeFile(folder.write(file.name, file.bytes), folder / "");
    CHECK(verdict.fault.empty());
    CHECK((verdict.ending == Ending::picture || verdict.ending == Ending::picture_with_warnings));
  }
}

TEST_CASE("variants are the same for the same seed") {
  Randomness first(kSeed);
  Randomness second(kSeed);
  const std::string text = "v 0 1 2\nf 1 2 3\n";
  for (int i = 0; i < 100; ++i) REQUIRE(damaged(text, first) == damaged(text, second));
}

TEST_CASE("a few damaged files of each kind end in a picture or a refusal") {
  judgeAllKinds(2);
}

TEST_CASE("thousands of damaged files end in a picture or a refusal", "[long]") {
  judgeAllKinds(100);
}
