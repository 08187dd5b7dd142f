#include "renderer/core/file.h"

#include <fcntl.h>
#include <sys/resource.h>
#include <sys/stat.h>

#include <csignal>
#include <thread>

#include "renderer/core/held_signals.h"
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

// While it lives, signals of that kind are counted instead of ending the process.
class CountedSignal {
 public:
  explicit CountedSignal(int signal)
      : signal_(signal), old_handler_(std::signal(signal, [](int) { count_ = count_ + 1; })) {
    count_ = 0;
  }
  CountedSignal(const CountedSignal&) = delete;
  CountedSignal& operator=(const CountedSignal&) = delete;
  ~CountedSignal() { std::signal(signal_, old_handler_); }

  int count() const { return count_; }

 private:
  inline static volatile std::sig_atomic_t count_ = 0;
  int signal_;
  void (*old_handler_)(int);
};

fs::perms modeOf(const fs::path& path) {
  return fs::status(path).permissions();
}

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

TEST_CASE("a link to a file that is not there yet is written through, and one to itself is not") {
  const TemporaryFolder folder;
  fs::create_directory(folder / "pictures");
  fs::create_symlink("pictures/second", folder / "first");  // relative to the link
  fs::create_symlink(folder / "pictures/file", folder / "pictures/second");
  writeFile(folder / "first", "bytes");
  CHECK(contentOf(folder / "pictures/file") == "bytes");
  CHECK(fs::is_symlink(folder / "first"));
  CHECK(fs::is_symlink(folder / "pictures/second"));

  fs::create_symlink("circle", folder / "circle");
  CHECK_THAT(messageOf(ErrorKind::failed, [&] { writeFile(folder / "circle", "bytes"); }),
             Catch::Contains("Too many levels of symbolic links"));
  CHECK(fs::is_symlink(folder / "circle"));
}

TEST_CASE("a file keeps its permissions when it is replaced, and a first one gets the usual ones") {
  const TemporaryFolder folder;
  const fs::path path = folder.write("file", "old");
  for (const auto mode : {fs::perms(0600), fs::perms(0666), fs::perms(0755)}) {
    fs::permissions(path, mode);
    writeFile(path, "bytes");
    CHECK(modeOf(path) == mode);
  }
  const mode_t before = umask(027);
  writeFile(folder / "first", "bytes");
  umask(before);
  CHECK(modeOf(folder / "first") == fs::perms(0640));
}

TEST_CASE("a name that fills the room for names can be written") {
  const TemporaryFolder folder;
  const std::string name(255, 'n');
  writeFile(folder / name, "bytes");
  CHECK(contentOf(folder / name) == "bytes");
}

TEST_CASE("a pipe is written to, and standard output from where it stands") {
  const TemporaryFolder folder;
  const fs::path pipe = folder / "pipe";
  REQUIRE(mkfifo(pipe.c_str(), 0600) == 0);
  std::string received;
  std::thread reader([&] { received = contentOf(pipe); });
  writeFile(pipe, "bytes");
  reader.join();
  CHECK(received == "bytes");
  CHECK(fs::is_fifo(pipe));

  // As a shell does with > or >>.
  const fs::path log = folder.write("log", "");
  const int descriptor = open(log.c_str(), O_WRONLY);
  REQUIRE(write(descriptor, "before ", 7) == 7);
  writeFile("/dev/fd/" + std::to_string(descriptor), "bytes");
  REQUIRE(write(descriptor, " after", 6) == 6);
  close(descriptor);
  CHECK(contentOf(log) == "before bytes after");
}

TEST_CASE("signals that come while they are held act when they are not held any more") {
  const CountedSignal interrupts(SIGINT);
  {
    const HeldSignals held;
    std::raise(SIGINT);
    CHECK(interrupts.count() == 0);
  }
  CHECK(interrupts.count() == 1);
  { const HeldSignals held; }
  CHECK(interrupts.count() == 1);
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
