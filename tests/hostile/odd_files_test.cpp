// Files made to bring a loader down: huge, deep, endless, or not files at all.
#include <sys/stat.h>
#include <unistd.h>

#include <catch2/catch.hpp>

#include "tests/hostile/good_files.h"
#include "tests/hostile/good_png.h"
#include "tests/hostile/verdict.h"
#include "tests/unit/temporary_folder.h"

using namespace glimt;
namespace fs = std::filesystem;

namespace {

constexpr std::size_t kLong = 10'000'000;

std::string repeated(const std::string& text, std::size_t bytes) {
  std::string out;
  out.reserve(bytes + text.size());
  while (out.size() < bytes) out += text;
  return out;
}

// Faces that are far from convex, of a size that is the dearest to cut.
std::string spikes(std::size_t bytes) {
  constexpr int kCorners = 1000;
  std::string out;
  for (int i = 0; i < kCorners; ++i) {
    out += "v " + std::to_string(i * 7919 % kCorners) + ' ' + std::to_string(i * 104729 % 997) +
           " 0\n";
  }
  std::string face = "f";
  for (int i = kCorners; i > 0; --i) face += " -" + std::to_string(i);
  return out + repeated(face + '\n', bytes);
}

constexpr const char* kTriangle = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";

class OddFiles {
 public:
  explicit OddFiles(std::string group) : tally_(std::move(group)) {
    folder_.write("scene.obj", kTriangle);
  }
  OddFiles(const OddFiles&) = delete;
  OddFiles& operator=(const OddFiles&) = delete;
  ~OddFiles() {
    tally_.report();
    for (const std::string& fault : tally_.faults()) FAIL_CHECK(fault);
  }

  void judge(const std::string& name, const std::string& bytes) {
    add(name, judgeFile(folder_.write(name, bytes), folder_ / ""));
  }
  // Of something that is there.
  void judgePath(const std::string& name) { add(name, judgeFile(folder_ / name, folder_ / "")); }
  void demand(const std::string& name, const std::string& bytes, Ending ending) {
    const Verdict verdict = judgeFile(folder_.write(name, bytes), folder_ / "");
    add(name, verdict);
    CAPTURE(name);
    CHECK(verdict.ending == ending);
  }
  const TemporaryFolder& folder() const { return folder_; }

 private:
  void add(const std::string& name, const Verdict& verdict) { tally_.add(name, verdict); }

  TemporaryFolder folder_;
  Tally tally_;
};

}  // namespace

TEST_CASE("files of one endless line") {
  OddFiles files("single lines of 10 MB");
  files.judge("word.obj", std::string(kLong, 'x'));
  files.judge("number.obj", "v " + std::string(kLong, '1') + " 0 0\n" + kTriangle);
  files.judge("face.obj", std::string(kTriangle) + "f" + repeated(" 1 2 3", kLong));
  files.judge("continued.obj", repeated("\\\n", kLong));
  files.judge("remark.obj", "#" + std::string(kLong, ' ') + '\n' + kTriangle);
  files.judge("material.obj", "usemtl " + std::string(kLong, 'm') + '\n' + kTriangle);
  files.judge("libraries.obj", "mtllib" + repeated(" a", kLong) + '\n' + kTriangle);
  files.judge("name.mtl", "newmtl " + std::string(kLong, 'm'));
  files.judge("color.mtl", "newmtl a\nKd " + std::string(kLong, '9'));
  files.judge("string.scene.json", R"({"model": ")" + std::string(kLong, 'x') + "\"}");
  files.judge("number.scene.json", R"({"model": )" + std::string(kLong, '1') + "}");
  files.judge("blank.scene.json", std::string(kLong, ' '));
  files.judge("header.hdr", "#?RADIANCE " + std::string(kLong, 'x'));
  files.judge("word.pfm", "PF " + std::string(kLong, '1'));
}

TEST_CASE("files of endless lines") {
  OddFiles files("10 MB of lines");
  files.judge("empty.obj", std::string(kLong, '\n'));
  files.judge("vertices.obj", repeated("v 1 2 3\n", kLong));
  files.judge("spikes.obj", spikes(kLong));
  std::string names = kTriangle;
  std::string libraries = kTriangle;
  std::string materials;
  std::string settings = R"({"model": "scene.obj", "materials": {"x": {})";
  for (int i = 0; i < 500'000; ++i) {
    const std::string number = std::to_string(i);
    names += "usemtl m" + number + "\nf 1 2 3\n";
    libraries += "mtllib l" + number + '\n';
    materials += "newmtl m" + number + '\n';
    settings += ", \"m" + number + "\": {}";
  }
  files.judge("materials.obj", names);
  files.judge("libraries.obj", libraries);
  files.judge("materials.mtl", materials);
  files.judge("settings.scene.json", settings + "}}");
}

TEST_CASE("nested JSON") {
  OddFiles files("JSON of 100,000 levels");
  files.demand("arrays.scene.json", std::string(100'000, '['), Ending::refused);
  files.demand("objects.scene.json", repeated("{\"model\":", 900'000), Ending::refused);
  files.demand("closed.scene.json",
               "{\"model\": " + std::string(100'000, '[') + std::string(100'000, ']') + "}",
               Ending::refused);
}

TEST_CASE("headers that claim what the file does not hold") {
  OddFiles files("sizes claimed");
  files.demand("huge.pfm", "PF\n100000 100000\n-1\n", Ending::refused);
  files.demand("overflow.pfm", "PF\n2147483647 2147483647\n-1\n", Ending::refused);
  files.demand("negative.pfm", "PF\n-1 -1\n-1\n", Ending::refused);
  files.demand("huge.hdr", "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 99999 +X 99999\n",
               Ending::refused);
  files.demand("nonsense.hdr", "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y nan +X inf\n",
               Ending::refused);
  files.demand("size.scene.json", R"({"model": "scene.obj", "render": {"size": [16384, 16384]}})",
               Ending::refused);
  files.demand("bounces.scene.json", R"({"model": "scene.obj", "render": {"bounces": 1e9}})",
               Ending::refused);
  files.demand("exploding.png", explodingPng(std::size_t{5} << 29), Ending::refused);
  for (const GoodFile& file : goodFiles()) {
    if (file.kind != "png" && file.kind != "exr") continue;
    std::string bytes = file.bytes;
    const std::size_t window = bytes.find("dataWindow");
    const std::size_t size = file.kind == "png" ? 16 : window + 29;
    bytes.replace(size, 4, "\x7f\xff\xff\x7f");
    files.demand("claims-" + file.name, bytes, Ending::refused);
  }
}

TEST_CASE("materials of nonsense values") {
  OddFiles files("nonsense in MTL");
  for (const char* value : {"nan", "inf", "-inf", "1e999", "-1", "x", "", "1e38 1e38 1e38",
                            "spectral f.rfl 1", "xyz 1 1 1", "0x10", "1,5 2 3"}) {
    std::string mtl = "newmtl a\n";
    for (const char* key : {"Kd", "Ke", "Ks", "Ns", "Ni", "d", "Tr", "illum", "Pr", "map_Kd"}) {
      mtl += std::string(key) + ' ' + value + '\n';
    }
    files.judge("nonsense.mtl", mtl);
  }
}

TEST_CASE("paths with blanks and UTF-8") {
  OddFiles files("paths");
  const std::string mtl = "newmtl a\nKd 1 0 0\n";
  for (const char* name : {"two  words", "Træ ❤ 日本語", "-o", "%s%n", "quote'\"", "a;b"}) {
    files.folder().write(std::string(name) + "/m.mtl", mtl);
    files.demand(std::string(name) + "/a model.obj",
                 std::string("mtllib m.mtl\nusemtl a\n") + kTriangle,
                 Ending::picture_with_warnings);
  }
  files.demand("bad\nname\x1b.obj", "no model", Ending::refused);
}

TEST_CASE("what is no file, or may not be read") {
  OddFiles files("no files");
  const TemporaryFolder& folder = files.folder();
  for (const char* extension : {"obj", "scene.json", "mtl.obj", "gltf"}) {
    const std::string name = std::string("folder.") + extension;
    fs::create_directory(folder / name);
    files.judgePath(name);
  }
  fs::create_directory(folder / "sky.hdr");
  files.demand("sky.scene.json", R"({"model": "scene.obj", "environment": {"image": "sky.hdr"}})",
               Ending::refused);
  files.demand("itself.scene.json", R"({"model": "itself.scene.json"})", Ending::refused);
  files.demand("device.scene.json", R"({"model": "/dev/zero"})", Ending::refused);
  files.demand("memory.scene.json",
               R"({"model": "scene.obj", "environment": {"image": "/proc/self/mem"}})",
               Ending::refused);
  fs::create_symlink("loop.obj", folder / "loop.obj");
  fs::create_symlink("/dev/zero", folder / "zero.obj");
  fs::create_symlink("nowhere", folder / "dangling.obj");
  REQUIRE(mkfifo((folder / "pipe.obj").c_str(), 0600) == 0);
  for (const char* name : {"loop.obj", "zero.obj", "dangling.obj", "pipe.obj", "absent.obj"}) {
    files.judgePath(name);
  }
  for (const char* name : {"secret.obj", "secret.scene.json"}) {
    folder.write(name, kTriangle);
    fs::permissions(folder / name, fs::perms::none);
    // As root everything can be read.
    if (access((folder / name).c_str(), R_OK) != 0) files.judgePath(name);
  }
  for (const char* name : {"sparse.obj", "sparse.hdr", "sparse.pfm", "sparse.scene.json"}) {
    folder.write(name, "");
    fs::resize_file(folder / name, std::uintmax_t{1} << 34);
    files.judgePath(name);
  }
  folder.write("zeros.obj", "");
  fs::resize_file(folder / "zeros.obj", 500'000'000);
  files.judgePath("zeros.obj");
}
