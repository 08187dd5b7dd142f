// Measured figures, on one line each, so that a run shows how far from its bounds a test stays.
#pragma once

#include <fmt/format.h>

#include <cstdio>

namespace glimt::test {

template <class... Values>
void report(fmt::format_string<Values...> format, Values&&... values) {
  fmt::print("  {}\n", fmt::format(format, std::forward<Values>(values)...));
  std::fflush(stdout);
}

}  // namespace glimt::test
