#include "tests/shader/error_statistics.h"

#include <catch2/catch.hpp>
#include <cmath>

using glimt::test::ErrorStatistics;

TEST_CASE("error statistics know the worst, and the percentile to a 32nd") {
  ErrorStatistics errors;
  for (int i = 10000; i > 0; --i) errors.add(i * 1e-9);
  CHECK(errors.count() == 10000);
  CHECK(errors.worst() == 1e-5);
  for (const double share : {0.25, 0.5, 0.9, 0.999}) {
    CAPTURE(share);
    CHECK(errors.percentile(share) >= share * 1e-5 * (1 - 1e-12));
    CHECK(errors.percentile(share) <= share * 1e-5 * 33 / 32);
  }
  CHECK(errors.percentile(1) == 1e-5);
}

TEST_CASE("error statistics count zeros, and take what is not a number for infinite") {
  ErrorStatistics errors;
  for (int i = 0; i < 999; ++i) errors.add(0);
  errors.add(3);
  CHECK(errors.percentile(0.999) == 0);
  errors.add(std::nan(""));
  CHECK(std::isinf(errors.worst()));
}
