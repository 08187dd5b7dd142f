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

[[noreturn]] void cannotWrite(const fs::path& path, int error) {
  throw Error(ErrorKind::failed,
              fmt::format("{}: cannot write ({}); check the folder and the space on the disk",
                          printable(path.string()), std::strerror(error)));
}

// Zero, or the errno of the first thing that went wrong.
int writeAll(const fs::path& path, const char* mode, std::string_view bytes) {
  errno = 0;
  OpenFile file(std::fopen(path.c_str(), mode));
  if (!file) return errno;
  const bool written = std::fwrite(bytes.data(), 1, bytes.size(), file.get()) == bytes.size() &&
                       std::fflush(file.get()) == 0;
  const int error = written ? 0 : (errno != 0 ? errno : EIO);
  const bool closed = std::fclose(file.release()) == 0;
  if (error != 0) return error;
  return closed ? 0 : (errno != 0 ? errno : EIO);
}

// A name beside the target that nobody uses; the number tells apart several writers.
fs::path temporaryBeside(const fs::path& path, int attempt) {
  return path.parent_path() / fmt::format(".{}.{}.part", path.filename().string(), attempt);
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

void writeFile(const fs::path& path, std::string_view bytes) {
  std::error_code error;
  const fs::file_status status = fs::status(path, error);
  if (fs::is_directory(status)) cannotWrite(path, EISDIR);
  if (fs::exists(status) && !fs::is_regular_file(status)) {
    if (const int failure = writeAll(path, "wb", bytes)) cannotWrite(path, failure);
    return;
  }
  // Through a link, the file that it names is replaced and not the link.
  error.clear();  // a file that is not there yet is no error
  const fs::path target = fs::exists(status) ? fs::canonical(path, error) : path;
  if (fs::exists(status) && error) cannotWrite(path, error.value());

  fs::path temporary;
  int failure = EEXIST;
  for (int attempt = 0; failure == EEXIST && attempt < 100; ++attempt) {
    temporary = temporaryBeside(target, attempt);
    failure = writeAll(temporary, "wbx", bytes);
  }
  if (failure == 0) {
    fs::rename(temporary, target, error);
    failure = error.value();
  }
  if (failure != 0) {
    if (failure != EEXIST) fs::remove(temporary, error);
    cannotWrite(path, failure);
  }
}

}  // namespace glimt
