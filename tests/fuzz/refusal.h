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
    // What a value must be is what to do about it.
    const bool says_what_to_do =
        message.find("; ") != std::string::npos || message.find(" must be ") != std::string::npos;
    if (error.kind() == ErrorKind::input && says_what_to_do &&
        message.find('\n') == std::string::npos) {
      return;
    }
    std::fprintf(stderr, "no proper refusal: %s\n", message.c_str());
    std::abort();
  }
}

}  // namespace glimt
