// What a loader may do with any file: load it, or refuse it.
#pragma once

#include <cstdio>
#include <cstdlib>
#include <string>

#include "renderer/core/error.h"

namespace glimt {

// Ends the program unless `load` comes back or throws an Error input of one line.
template <typename Load>
void demandLoadedOrRefused(Load&& load) {
  try {
    load();
  } catch (const Error& error) {
    const std::string message = error.what();
    if (error.kind() == ErrorKind::input && message.find("; ") != std::string::npos &&
        message.find('\n') == std::string::npos) {
      return;
    }
    std::fprintf(stderr, "no proper refusal: %s\n", message.c_str());
    std::abort();
  }
}

}  // namespace glimt
