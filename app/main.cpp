#include <csignal>
#include <exception>
#include <new>
#include <string>

#include "app/command_line.h"
#include "app/message.h"
#include "renderer/core/error.h"

int main(int argc, char** argv) {
  // A file that grows beyond the limit of its size is an error that can be told, not the end.
  std::signal(SIGXFSZ, SIG_IGN);
  try {
    return glimt::runCommandLine({argv + 1, argv + argc});
  } catch (const glimt::Error& error) {
    glimt::say(error.what());
    return static_cast<int>(error.kind());
  } catch (const std::bad_alloc&) {
    glimt::say("out of memory");
  } catch (const std::exception& error) {
    glimt::say(std::string("unexpected error: ") + error.what());
  }
  return static_cast<int>(glimt::ErrorKind::failed);
}
