// Any bytes as one of the three files of a scene, beside two good ones, or as a glTF file.
// GLIMT_FUZZ_FILE names it.
#include <unistd.h>

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <string>
#include <string_view>

#include "renderer/scene/load_scene.h"
#include "tests/fuzz/refusal.h"
#include "tests/hostile/safe_scene.h"

namespace {

namespace fs = std::filesystem;

class SceneFolder {
 public:
  SceneFolder() {
    std::string name = (fs::temp_directory_path() / "glimt-fuzz-XXXXXX").string();
    if (mkdtemp(name.data()) == nullptr) std::abort();
    path_ = name;
    write("scene.mtl", "newmtl a\nKd 0.1 0.2 0.3\nKe 1 2 3\n");
    write("scene.obj",
          "mtllib scene.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 1\nusemtl a\nf 1 2 3\nf 1 3 4\n");
    write("scene.scene.json", R"({"model": "scene.obj"})");
  }
  SceneFolder(const SceneFolder&) = delete;
  SceneFolder& operator=(const SceneFolder&) = delete;
  ~SceneFolder() {
    std::error_code ignored;
    fs::remove_all(path_, ignored);
  }

  void write(const char* name, std::string_view bytes) const {
    std::ofstream(path_ / name, std::ios::binary) << bytes;
  }
  // What leads to that file.
  fs::path sceneWith(std::string_view name) const {
    const bool is_gltf = name.ends_with(".gltf") || name.ends_with(".glb");
    return path_ / (is_gltf ? name : "scene.scene.json");
  }

 private:
  fs::path path_;
};

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace glimt;
  static const SceneFolder folder;
  folder.write(GLIMT_FUZZ_FILE, std::string_view(reinterpret_cast<const char*>(data), size));
  demandLoadedOrRefused([&] {
    const std::string flaw = flawOf(loadScene(folder.sceneWith(GLIMT_FUZZ_FILE)));
    if (flaw.empty()) return;
    std::fprintf(stderr, "unsafe scene: %s\n", flaw.c_str());
    std::abort();
  });
  return 0;
}
