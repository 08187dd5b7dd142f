#include "app/output_files.h"

#include <fmt/format.h>
#include <unistd.h>

#include <string>
#include <system_error>

#include "renderer/core/error.h"
#include "renderer/core/file.h"
#include "renderer/core/image_file.h"
#include "renderer/core/wording.h"

namespace glimt {
namespace {

namespace fs = std::filesystem;

std::string faultOf(const fs::path& file) {
  std::error_code ignored;
  const fs::path target = outputTarget(file);
  const fs::file_status status = fs::status(file, ignored);
  if (fs::is_directory(status)) return "it is a folder; name a file in it";
  if (fs::exists(status) && access(file.c_str(), W_OK) != 0) return "it is write-protected";
  // A regular file is replaced by a new one in its folder; a pipe or a device is written to.
  if (fs::exists(status) && !fs::is_regular_file(status)) return {};
  if (fs::is_symlink(target, ignored)) {
    return fs::exists(status) ? "" : "it is a link that leads nowhere";
  }
  const fs::path folder = target.has_parent_path() ? target.parent_path() : fs::path(".");
  const std::string name = folder.string();
  if (!fs::exists(folder, ignored)) {
    return fmt::format("there is no folder '{}'; create it first", name);
  }
  if (!fs::is_directory(folder, ignored)) return fmt::format("'{}' is not a folder", name);
  if (access(folder.c_str(), W_OK | X_OK) != 0) {
    return fmt::format("the folder '{}' is write-protected", name);
  }
  return {};
}

}  // namespace

void checkWritable(const fs::path& file) {
  const std::string fault = faultOf(file);
  if (fault.empty()) return;
  throw Error(ErrorKind::usage, fmt::format("{}: cannot be written: {}", file.string(), fault));
}

void checkCanTellDenoised(const fs::path& file) {
  if (imageFormatOf(file) == ImageFormat::pfm)
    throw Error(ErrorKind::usage,
                fmt::format("{}: a .pfm cannot say that its picture is denoised; use .exr",
                            printable(file.string())));
}

void makeFolder(const fs::path& folder) {
  std::error_code error;
  fs::create_directories(folder, error);
  if (!error) return;
  throw Error(ErrorKind::failed, fmt::format("{}: cannot make the folder ({}); name another",
                                             printable(folder.string()), error.message()));
}

}  // namespace glimt
