#include "renderer/core/file.h"

#include <sys/resource.h>

#include <csignal>

#include "tests/unit/expect_error.h"
#include "tests/unit/temporary_folder.h"

using namespace glimt;
namespace fs = std::filesystem;

namespace {

// While it lives, no file may grow beyond `bytes`: the disk is as good as full.
class SmallDisk {
 public:
  explicit SmallDisk(rlim_t bytes) : old_handler_(std::signal(SIGXFSZ, SIG_IGN)) {
    getrlimit(RLIMIT_FSIZE, &old_limit_);
    const rlimit limit{bytes, old_limit_.rlim_max};
    setrlimit(RLIMIT_FSIZE, &limit);
  }
  SmallDisk(const SmallDisk&) = delete;
  SmallDisk& operator=(const SmallDisk&) = delete;
  ~SmallDisk() {
    setrlimit(RLIMIT_FSIZE, &old_limit_);
    std::signal(SIGXFSZ, old_handler_);
  }

 private:
  rlimit old_limit_{};
  void (*old_handler_)(int);
};

}  // namespace

TEST_CASE("a written file is read back byte by byte, also under a name in UTF-8 with blanks") {
  const TemporaryFolder folder;
  const std::string bytes("a\0b\xff\r\n", 6);
  const fs::path path = folder / "smukt glimt \xe2\x99\xbb.bin";
  writeFile(path, bytes);
  CHECK(readFile(path, 100) == bytes);
  CHECK(folder.fileCount() == 1);
}

TEST_CASE("writing replaces what was there, and through a link what the link names") {
  const TemporaryFolder folder;
  const fs::path path = folder.write("file", "something old and longer");
  fs::create_symlink(path, folder / "link");
  writeFile(folder / "link", "new");
  CHECK(contentOf(path) == "new");
  CHECK(fs::is_symlink(folder / "link"));
}

TEST_CASE("a write that fails midway leaves the old file and no temporary") {
  const TemporaryFolder folder;
  const fs::path path = folder.write("file", "old");
  const std::string large(100'000, 'x');
  std::string message;
  {
    const SmallDisk disk(50'000);
    message = messageOf(ErrorKind::failed, [&] { writeFile(path, large); });
  }
  CHECK_THAT(message, Catch::Contains("cannot write (File too large)"));
  CHECK(contentOf(path) == "old");
  CHECK(folder.fileCount() == 1);
}

TEST_CASE("writing where no file can be is an error that gives the reason") {
  const TemporaryFolder folder;
  const auto message = [&](const fs::path& path) {
    return messageOf(ErrorKind::failed, [&] { writeFile(path, "bytes"); });
  };
  CHECK_THAT(message(folder / "none/file"), Catch::Contains("No such file or directory"));
  CHECK_THAT(message(folder / ""), Catch::Contains("Is a directory"));
  CHECK_THAT(message("/dev/full"), Catch::Contains("No space left on device"));
}

TEST_CASE("what is no regular file is written to and not replaced") {
  writeFile("/dev/null", "bytes");
  CHECK(fs::is_character_file("/dev/null"));
}

TEST_CASE("reading what is no file of at most the given size is an error that gives the reason") {
  const TemporaryFolder folder;
  folder.write("file", "12345");
  const auto message = [&](const fs::path& path, std::uintmax_t largest) {
    return messageOf(ErrorKind::input, [&] { readFile(path, largest); });
  };
  CHECK_THAT(message(folder / "none", 5), Catch::Contains("no such file"));
  CHECK_THAT(message(folder / "", 5), Catch::Contains("it is a folder"));
  CHECK_THAT(message("/dev/zero", 5), Catch::Contains("no regular file"));
  CHECK_THAT(message(folder / "file", 4), Catch::Contains("5 bytes"));
  CHECK(readFile(folder / "file", 5) == "12345");
}
