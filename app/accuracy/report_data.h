// The report of glimt accuracy for programs.
#pragma once

#include <string>

#include "app/accuracy/measurement.h"
#include "app/accuracy/report_page.h"
#include "app/json_output.h"

namespace glimt {

Json jsonReport(const ReportSubject& subject, const AccuracyResult& result);

// A row for every point of every curve, with the time that the whole picture takes.
std::string csvReport(const ReportSubject& subject, const AccuracyResult& result);

}  // namespace glimt
