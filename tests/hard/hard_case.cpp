#include "tests/hard/hard_case.h"

#include <fmt/format.h>

#include <catch2/catch.hpp>
#include <cstdlib>
#include <fstream>

namespace glimt::test {

std::string hardDriver() {
  const char* driver = std::getenv("GLIMT_HARD_DRIVER");
  return driver ? driver : "llvmpipe";
}

ContextHandle hardContext() {
  return createOffscreenContext(hardDriver() == "osmesa" ? Backend::osmesa : Backend::egl, 2);
}

bool slowDriver() {
  return hardDriver() == "softpipe" || hardDriver() == "zink";
}

void checkAtMost(const std::string& group, const std::string& name, const std::string& what,
                 double measured, double bound) {
  INFO(group << ", " << name << ": " << what);
  CHECK(measured <= bound);
  const char* file = std::getenv("GLIMT_HARD_REPORT");
  if (!file) return;
  std::ofstream(file, std::ios::app) << fmt::format("{}\t{}\t{}\t{:.3g}\t{:.3g}\t{}\n", group, name,
                                                    what, bound, measured, hardDriver());
}

}  // namespace glimt::test
