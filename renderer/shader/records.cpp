#include "renderer/shader/records.h"

#include <fmt/format.h>

#include "renderer/core/error.h"

namespace glimt {

const std::vector<Record>& records() {
  static const std::vector<Record> kRecords{
      {"packed", "packed_record_input.glsl", "packed_record_output.glsl", {"uRecord"}},
      {"wide",
       "wide_record_input.glsl",
       "wide_record_output.glsl",
       {"uRecord", "uRecordDirection", "uRecordThroughput"},
       3},
  };
  return kRecords;
}

const Record& recordNamed(const std::string& name) {
  for (const Record& record : records())
    if (name == record.name) return record;
  throw Error(ErrorKind::usage,
              fmt::format("there is no record '{}'; there are: packed, wide", name));
}

}  // namespace glimt
