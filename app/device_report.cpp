#include "app/device_report.h"

#include <fmt/format.h>

#include <cmath>
#include <thread>

#include "renderer/core/wording.h"

namespace glimt {
namespace {

double rounded(double value) {
  return std::round(value * 1e6) / 1e6;
}

void addRate(Json& json, const std::string& key, const std::optional<Spread>& rate) {
  json[key] = rate ? Json(rounded(rate->median)) : Json(nullptr);
  json[key + "_least"] = rate ? Json(rounded(rate->least)) : Json(nullptr);
  json[key + "_most"] = rate ? Json(rounded(rate->most)) : Json(nullptr);
}

Json jsonOf(const DeviceRow& row, const ContextInfo& context) {
  Json json{{"suite", "device"},
            {"work", row.work},
            {"unit", row.unit},
            {"side", row.side},
            {"gles", context.gles}};
  addRate(json, "rate", row.rate);
  if (!row.note.empty()) json["note"] = row.note;
  return json;
}

Json jsonOf(const TraversalBoundRow& row, const ContextInfo& context) {
  Json json{{"suite", "device"},
            {"work", "traversal"},
            {"triangles", row.triangles},
            {"traversal", row.traversal},
            {"rays", row.rays},
            {"gles", context.gles},
            {"node_fetches_per_ray", rounded(row.per_ray.node_fetches)},
            {"triangle_fetches_per_ray", rounded(row.per_ray.triangle_fetches)},
            {"box_tests_per_ray", rounded(row.per_ray.box_tests)},
            {"triangle_tests_per_ray", rounded(row.per_ray.triangle_tests)},
            {"fetch_rate", rounded(row.fetchRate())},
            {"fetch_ceiling", rounded(row.fetch_ceiling)},
            {"fetch_bound_mrays", rounded(row.fetch_bound)},
            {"arithmetic_bound_mrays", rounded(row.arithmetic_bound)}};
  addRate(json, "mrays", row.rate);
  return json;
}

// The rates of a work in pictures of different sizes stand on one line.
std::string ceilingsText(const std::vector<DeviceRow>& rows) {
  std::string text;
  std::string work;
  for (const DeviceRow& row : rows) {
    if (row.work != work) text += fmt::format("\n  {:<34} {:<11}", row.work, row.unit);
    work = row.work;
    text += row.rate ? fmt::format("  {:>5}: {:>8.4g} [{:>8.4g} {:>8.4g}]", row.side,
                                   row.rate->median, row.rate->least, row.rate->most)
                     : fmt::format("  {:>5}: {}", row.side, row.note);
  }
  return text + "\n";
}

std::string boundsText(const std::vector<TraversalBoundRow>& rows) {
  std::string text =
      fmt::format("  {:<13} {:<7} {:>6} {:>9} {:>6} {:>9} {:>9} {:>9} {:>9}\n", "traversal", "rays",
                  "nodes", "tri texels", "boxes", "triangles", "rate", "fetches", "arithmetic");
  for (const TraversalBoundRow& row : rows)
    text += fmt::format(
        "  {:<13} {:<7} {:>6.1f} {:>10.1f} {:>6.1f} {:>9.1f} {:>9.2f} {:>9.2f} {:>10.2f}\n",
        row.traversal, row.rays, row.per_ray.node_fetches, row.per_ray.triangle_fetches,
        row.per_ray.box_tests, row.per_ray.triangle_tests, row.rate.median, row.fetch_bound,
        row.arithmetic_bound);
  return text;
}

std::string sentenceOf(const TraversalBoundRow& row) {
  return fmt::format(
      "{} {}: {:.1f} fetches/ray x {:.3g} Mrays/s = {:.3g} of {:.3g} G fetches/s: {:.0f}% of the "
      "ceiling; {:.0f}% of that of arithmetic\n",
      row.traversal, row.rays, row.per_ray.fetches(), row.rate.median, row.fetchRate(),
      row.fetch_ceiling, 100 * row.fetchRate() / row.fetch_ceiling,
      100 * row.rate.median / row.arithmetic_bound);
}

}  // namespace

std::string textOf(const DeviceBench& bench, const ContextInfo& context) {
  std::string text = fmt::format("{}, {}\nside of the picture: median [least most]\n",
                                 context.renderer, context.version);
  text += ceilingsText(bench.ceilings);
  if (bench.bounds.empty()) return text;
  text += fmt::format(
      "\n{}: what a ray takes; million rays per second as measured, and if only its fetches or "
      "its arithmetic took time\n",
      counted(bench.bounds.front().triangles, "triangle"));
  text += boundsText(bench.bounds) + "\n";
  for (const TraversalBoundRow& row : bench.bounds) text += sentenceOf(row);
  return text;
}

Json jsonOf(const DeviceBench& bench, const ContextInfo& context) {
  Json list = Json::array();
  for (const DeviceRow& row : bench.ceilings) list.push_back(jsonOf(row, context));
  for (const TraversalBoundRow& row : bench.bounds) list.push_back(jsonOf(row, context));
  return {{"gl_renderer", context.renderer},
          {"gl_version", context.version},
          {"cores", std::thread::hardware_concurrency()},
          {"measurements", list}};
}

}  // namespace glimt
