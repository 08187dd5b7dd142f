#include "renderer/core/file.h"

#include <fmt/format.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <memory>

#include "renderer/core/error.h"
#include "renderer/core/wording.h"

namespace glimt {
namespace {

namespace fs = std::filesystem;

struct Close {
  void operator()(std::FILE* file) const { std::fclose(file); }
};
using OpenFile = std::unique_ptr<std::FILE, Close>;

[[noreturn]] void cannotRead(const fs::path& path, const std::string& why, const char* what_to_do) {
  throw Error(ErrorKind::input,
              fmt::format("{}: cannot read ({}); {}", printable(path.string()), why, what_to_do));
}

}  // namespace

std::string readFile(const fs::path& path, std::uintmax_t largest) {
  std::error_code error;
  const fs::file_status status = fs::status(path, error);
  if (!fs::exists(status)) cannotRead(path, "no such file", "check the path");
  if (fs::is_directory(status)) cannotRead(path, "it is a folder", "name a file in it");
  if (!fs::is_regular_file(status)) cannotRead(path, "it is no regular file", "name a file");
  const std::uintmax_t size = fs::file_size(path, error);
  if (error) cannotRead(path, error.message(), "check the path");
  if (size > largest) {
    cannotRead(path, fmt::format("{} bytes", grouped(size)),
               fmt::format("at most {} bytes are read", grouped(largest)).c_str());
  }
  OpenFile file(std::fopen(path.c_str(), "rb"));
  if (!file) cannotRead(path, std::strerror(errno), "check its permissions");
  std::string bytes(static_cast<std::size_t>(size), '\0');
  bytes.resize(std::fread(bytes.data(), 1, bytes.size(), file.get()));
  if (std::ferror(file.get())) cannotRead(path, std::strerror(errno), "check the disk");
  return bytes;
}

}  // namespace glimt
