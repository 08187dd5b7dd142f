#include "app/viewer/pace.h"

#include <catch2/catch.hpp>

using namespace glimt;

TEST_CASE("a picture answers the requests up to its own, each of them once") {
  Pace pace;
  pace.asked(1, 0.5);
  pace.asked(2, 0.25);
  pace.asked(3, 0);
  pace.shown(2);
  REQUIRE(pace.latencies().size() == 2);
  CHECK(pace.latencies()[0] >= 0.5);
  CHECK(pace.latencies()[1] >= 0.25);
  pace.shown(2);
  CHECK(pace.latencies().size() == 2);
  pace.shown(3);
  CHECK(pace.latencies().size() == 3);
  CHECK(pace.intervals().size() == 1);
}

TEST_CASE("quantiles are values of the list") {
  CHECK(quantile({}, 0.5) == 0);
  CHECK(quantile({3, 1, 2}, 0.5) == 2);
  CHECK(quantile({3, 1, 2}, 1) == 3);
  CHECK(quantile({3, 1, 2}, 0) == 1);
}
