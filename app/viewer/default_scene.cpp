#include "app/viewer/default_scene.h"

#include <system_error>

#include "renderer/core/error.h"

namespace glimt {

namespace fs = std::filesystem;

fs::path defaultScene() {
  std::error_code ignored;
  const fs::path folder = fs::read_symlink("/proc/self/exe", ignored).parent_path();
  for (const char* const place : {"../../assets", "../share/glimt"}) {
    const fs::path scene = (folder / place / "default.scene.json").lexically_normal();
    if (fs::exists(scene, ignored)) return scene;
  }
  throw Error(
      ErrorKind::usage,
      "the scene that comes with glimt is not beside the program; name one: glimt view SCENE");
}

}  // namespace glimt
