#include "app/accuracy/report_data.h"

#include <fmt/format.h>

namespace glimt {

Json jsonReport(const ReportSubject& subject, const AccuracyResult& result) {
  Json curves = Json::array();
  for (const AccuracyCurve& curve : result.curves) curves.push_back(jsonOf(curve));
  Json ways = Json::array();
  for (const Recommendation& way : recommendationsOf(result.curves))
    ways.push_back({{"error", way.goal},
                    {"samples", way.samples},
                    {"seconds", way.seconds * subject.time_factor},
                    {"command", commandOf(subject, result.curves[way.curve], way.samples)}});
  return {{"scene", subject.scene},
          {"width", subject.width},
          {"height", subject.height},
          {"measured_width", subject.measured_width},
          {"measured_height", subject.measured_height},
          {"time_factor", subject.time_factor},
          {"gl_renderer", result.context.renderer},
          {"reference",
           {{"samples", result.reference_samples},
            {"noise", result.reference_noise},
            {"bounces", result.reference_bounces}}},
          {"budget", jsonOf(result.budget)},
          {"recommended", ways},
          {"curves", curves}};
}

std::string csvReport(const ReportSubject& subject, const AccuracyResult& result) {
  std::string csv = "knob,value,samples,seconds,error\n";
  for (const AccuracyCurve& curve : result.curves)
    for (const AccuracyPoint& point : curve.points)
      csv += fmt::format("{},{},{},{:.6g},{:.6g}\n", curve.knob, curve.value, point.samples,
                         point.seconds * subject.time_factor, point.error);
  return csv;
}

}  // namespace glimt
