// The report of glimt accuracy as one HTML file, which needs nothing beside it.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "app/accuracy/measurement.h"

namespace glimt {

struct ReportPicture {
  std::string name;
  std::string png;         // bytes of the file
  std::string difference;  // the same of what differs from the reference; empty for the reference
};

struct ReportSubject {
  std::string scene;                                         // as on the command line
  std::vector<std::pair<std::string, std::string>> options;  // names and values given there
  int width = 0;                                             // that the picture is to have
  int height = 0;
  int measured_width = 0;  // that it was measured with
  int measured_height = 0;
  double time_factor = 1;  // how much longer the whole picture takes than the measured one
  std::string version;     // of glimt
};

// The command that renders a curve's variant with so many samples.
std::string commandOf(const ReportSubject& subject, const AccuracyCurve& curve, double samples);

std::string reportPage(const ReportSubject& subject, const AccuracyResult& result,
                       const std::vector<ReportPicture>& pictures);

}  // namespace glimt
