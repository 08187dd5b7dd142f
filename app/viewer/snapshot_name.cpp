#include "app/viewer/snapshot_name.h"

#include <fmt/format.h>

#include <system_error>

namespace glimt {

std::filesystem::path snapshotName(const std::string& name) {
  std::filesystem::path file = fmt::format("{}.png", name);
  std::error_code ignored;
  for (int number = 2; std::filesystem::exists(file, ignored); ++number) {
    file = fmt::format("{}-{}.png", name, number);
  }
  return file;
}

}  // namespace glimt
