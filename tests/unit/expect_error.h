// What an Error has to look like.
#pragma once

#include <catch2/catch.hpp>
#include <string>

#include "renderer/core/error.h"

namespace glimt {

// Runs `action`, demands an Error of that kind whose message is one line, and returns the message.
template <typename Action>
std::string messageOf(ErrorKind kind, Action&& action) {
  try {
    action();
  } catch (const Error& error) {
    const std::string message = error.what();
    CHECK(error.kind() == kind);
    CHECK_FALSE(message.empty());
    CHECK(message.find('\n') == std::string::npos);
    return message;
  }
  FAIL_CHECK("no Error was thrown");
  return {};
}

}  // namespace glimt
