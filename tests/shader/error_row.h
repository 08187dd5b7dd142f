// A row of docs/numerics.md: errors held to their bound.
#pragma once

#include <fmt/format.h>

#include <catch2/catch.hpp>
#include <cstdlib>
#include <fstream>
#include <string>

#include "tests/shader/error_statistics.h"
#include "tests/shader/report.h"

namespace glimt::test {

// Half of the last bit of a float in [1, 2): what one rounding is off by, relative to its result.
constexpr double kRounding = 0x1p-24;

// How many inputs a short test takes, and how many the table asks for.
constexpr int kShort = 200000;
constexpr int kLong = 10000000;

struct ErrorRow {
  std::string family;
  std::string function;
  std::string inputs;  // in words
  std::string unit;
  double bound = 0;  // of the worst, in that unit, from analysis
  std::string because;
};

// Checks the bound, reports the figures, and appends the row to the file that GLIMT_NUMERICS_REPORT
// names, if it does.
inline void checkErrors(const ErrorRow& row, const ErrorStatistics& errors) {
  INFO(row.function << ", " << row.inputs << ", in " << row.unit);
  CHECK(errors.count() > 0);
  CHECK(errors.worst() <= row.bound);
  const double most = errors.percentile(0.999);
  report("{}: {} inputs, worst {:.5g}, 99.9% below {:.5g}, bound {:.6g}; in {}", row.function,
         errors.count(), errors.worst(), most, row.bound, row.unit);
  const char* file = std::getenv("GLIMT_NUMERICS_REPORT");
  if (!file) return;
  std::ofstream(file, std::ios::app) << fmt::format(
      "{}\t{}\t{}\t{}\t{}\t{:.5g}\t{:.5g}\t{:.6g}\t{}\n", row.family, row.function, row.inputs,
      errors.count(), row.unit, errors.worst(), most, row.bound, row.because);
}

}  // namespace glimt::test
