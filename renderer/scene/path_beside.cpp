#include "renderer/scene/path_beside.h"

#include <algorithm>

namespace glimt {

namespace fs = std::filesystem;

fs::path pathBeside(const fs::path& folder, std::string name) {
  std::replace(name.begin(), name.end(), '\\', '/');
  std::error_code ignored;
  for (const fs::path& path : {folder / fs::path(name), folder / fs::path(name).filename()}) {
    if (!name.empty() && fs::exists(path, ignored) && !fs::is_directory(path, ignored)) return path;
  }
  return {};
}

}  // namespace glimt
