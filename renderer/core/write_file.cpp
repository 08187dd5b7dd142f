#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <optional>
#include <utility>

#include "renderer/core/error.h"
#include "renderer/core/file.h"
#include "renderer/core/held_signals.h"
#include "renderer/core/wording.h"

namespace glimt {
namespace {

namespace fs = std::filesystem;

// What stat() calls the mode holds these, beside the kind of file.
constexpr mode_t kPermissions = 07777;
constexpr mode_t kOwnerOnly = 0600;
constexpr mode_t kByUmask = 0666;

[[noreturn]] void cannotWrite(const fs::path& path, int error) {
  throw Error(ErrorKind::failed,
              fmt::format("{}: cannot write ({}); check the folder and the space on the disk",
                          printable(path.string()), std::strerror(error)));
}

void demand(bool done, const fs::path& path) {
  if (!done) cannotWrite(path, errno);
}

// An open file, closed with this at the latest. Errors name `path`.
class OutputFile {
 public:
  OutputFile(int descriptor, const fs::path& path) : descriptor_(descriptor), path_(path) {
    demand(descriptor_ >= 0, path_);
  }
  OutputFile(const OutputFile&) = delete;
  OutputFile& operator=(const OutputFile&) = delete;
  ~OutputFile() {
    if (descriptor_ >= 0) ::close(descriptor_);
  }

  void write(std::string_view bytes) const {
    while (!bytes.empty()) {
      const ssize_t written = ::write(descriptor_, bytes.data(), bytes.size());
      if (written < 0 && errno == EINTR) continue;
      demand(written >= 0, path_);
      bytes.remove_prefix(static_cast<std::size_t>(written));
    }
  }

  void setMode(mode_t mode) const { demand(::fchmod(descriptor_, mode) == 0, path_); }

  // Some file systems tell only here that the bytes did not find room.
  void close() { demand(::close(std::exchange(descriptor_, -1)) == 0, path_); }

 private:
  int descriptor_;
  const fs::path& path_;
};

// A file beside `target` that nobody else uses, gone with this unless it has taken the target's
// name. It is called after the process and not after the target, whose name may have no room left.
class TemporaryFile {
 public:
  TemporaryFile(const fs::path& target, mode_t mode) : target_(target) {
    int descriptor = -1;
    for (int attempt = 0; descriptor < 0 && attempt < 100; ++attempt) {
      name_ = target.parent_path() / fmt::format(".glimt-{}-{}.part", ::getpid(), attempt);
      descriptor = ::open(name_.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, mode);
      if (descriptor < 0 && errno != EEXIST) break;
    }
    file_.emplace(descriptor, target_);
  }
  TemporaryFile(const TemporaryFile&) = delete;
  TemporaryFile& operator=(const TemporaryFile&) = delete;
  ~TemporaryFile() {
    if (!renamed_) ::unlink(name_.c_str());
  }

  OutputFile& file() { return *file_; }

  void takeName() {
    file_->close();
    demand(::rename(name_.c_str(), target_.c_str()) == 0, target_);
    renamed_ = true;
  }

 private:
  const fs::path& target_;
  fs::path name_;
  std::optional<OutputFile> file_;
  bool renamed_ = false;
};

// `/dev/stdout` and its like end here: in the names of what this process has open.
bool namesDescriptor(const fs::path& path) {
  std::error_code ignored;
  return path.has_parent_path() && fs::equivalent(path.parent_path(), "/proc/self/fd", ignored);
}

// Into what is there already, from where it stands.
void writeInto(const fs::path& target, int descriptor, std::string_view bytes) {
  OutputFile file(descriptor, target);
  file.write(bytes);
  file.close();
}

// A new file of that name, which keeps the permissions of the one before.
void replace(const fs::path& target, std::string_view bytes) {
  struct stat before {};
  const bool exists = ::stat(target.c_str(), &before) == 0;
  const HeldSignals whole;
  TemporaryFile temporary(target, exists ? before.st_mode & kOwnerOnly : kByUmask);
  temporary.file().write(bytes);
  if (exists) temporary.file().setMode(before.st_mode & kPermissions);
  temporary.takeName();
}

}  // namespace

fs::path outputTarget(const fs::path& path) {
  constexpr int kMostLinks = 40;
  std::error_code error;
  fs::path target = path;
  for (int links = 0; links < kMostLinks; ++links) {
    if (!fs::is_symlink(target, error) || namesDescriptor(target)) break;
    const fs::path named = fs::read_symlink(target, error);
    if (error) break;
    target = target.parent_path() / named;
  }
  return target;
}

void writeFile(const fs::path& path, std::string_view bytes) {
  const fs::path target = outputTarget(path);
  if (namesDescriptor(target)) {
    const int number = std::atoi(target.filename().c_str());
    return writeInto(target, ::fcntl(number, F_DUPFD_CLOEXEC, 0), bytes);
  }
  std::error_code error;
  const fs::file_status status = fs::status(target, error);
  if (fs::is_directory(status)) cannotWrite(path, EISDIR);
  if (fs::is_symlink(target, error)) cannotWrite(path, ELOOP);
  if (fs::exists(status) && !fs::is_regular_file(status))
    return writeInto(target, ::open(target.c_str(), O_WRONLY | O_CLOEXEC), bytes);
  replace(target, bytes);
}

}  // namespace glimt
