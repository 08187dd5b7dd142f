#include "app/bench_report.h"

#include <fmt/format.h>

#include <cmath>
#include <thread>

#include "renderer/core/wording.h"

namespace glimt {
namespace {

double rounded(double value) {
  return std::round(value * 1e6) / 1e6;
}

Json jsonOf(const std::optional<double>& value) {
  return value ? Json(rounded(*value)) : Json(nullptr);
}

void addRates(Json& json, const TraversalRow& row) {
  for (std::size_t kind = 0; kind < kRayKinds.size(); ++kind) {
    const std::string key = fmt::format("{}_mrays", kRayKinds[kind]);
    if (!row.rates) {
      for (const char* end : {"", "_least", "_most"}) json[key + end] = nullptr;
      continue;
    }
    const Rate& rate = (*row.rates)[kind];
    json[key] = rounded(rate.median);
    json[key + "_least"] = rounded(rate.least);
    json[key + "_most"] = rounded(rate.most);
  }
}

Json jsonOf(const TraversalRow& row, const ContextInfo& context) {
  const bool measured = row.rates.has_value();
  Json json{{"suite", "traversal"},
            {"scene", row.scene},
            {"triangles", row.triangles},
            {"traversal", row.traversal},
            {"gles", row.traversal == kEmbree ? Json(nullptr) : Json(context.gles)}};
  addRates(json, row);
  json["compile_seconds"] = jsonOf(row.compile_seconds);
  json["bvh_seconds"] = measured ? Json(rounded(row.bvh_seconds)) : Json(nullptr);
  json["gpu_bytes_per_triangle"] = jsonOf(row.gpu_bytes_per_triangle);
  json["agrees"] = measured ? Json(row.agrees) : Json(nullptr);
  json["different"] = measured ? Json(row.different) : Json(nullptr);
  json["compared"] = measured ? Json(row.compared) : Json(nullptr);
  json["reference"] = measured ? Json(row.reference) : Json(nullptr);
  if (!row.note.empty()) json["note"] = row.note;
  return json;
}

std::string textOf(const Rate& rate) {
  return fmt::format("{:>6.2f} [{:>5.2f} {:>5.2f}]", rate.median, rate.least, rate.most);
}

// Of the comparison with the reference, which is not compared with itself.
std::string agreementOf(const TraversalRow& row) {
  if (row.traversal == row.reference) return "reference";
  return fmt::format("{} ({} of {})", row.agrees ? "yes" : "NO", grouped(row.different),
                     grouped(row.compared));
}

std::string textOf(const TraversalRow& row) {
  if (!row.rates) return fmt::format("  {:<13} {}\n", row.traversal, row.note);
  std::string text = fmt::format("  {:<13}", row.traversal);
  for (const Rate& rate : *row.rates) text += fmt::format(" {}", textOf(rate));
  text +=
      row.compile_seconds ? fmt::format(" {:>8.2f}", *row.compile_seconds) : std::string(9, ' ');
  text += row.gpu_bytes_per_triangle ? fmt::format(" {:>7.0f}", *row.gpu_bytes_per_triangle)
                                     : std::string(8, ' ');
  return text + fmt::format(" {:>7.2f}  {}\n", row.bvh_seconds, agreementOf(row));
}

}  // namespace

std::string textOf(const std::vector<TraversalRow>& rows, const ContextInfo& context) {
  std::string text = fmt::format("{}, {}\nmillion rays per second: median [least most]\n",
                                 context.renderer, context.version);
  std::size_t triangles = 0;
  for (const TraversalRow& row : rows) {
    if (row.triangles != triangles) {
      triangles = row.triangles;
      text += fmt::format("\n{}\n  {:<13} {:<20} {:<20} {:<20} {:>8} {:>7} {:>7}  {}\n",
                          counted(triangles, "triangle"), "traversal", "camera", "bounce", "shadow",
                          "compile", "B/tri", "BVH s", "agrees (differing)");
    }
    text += textOf(row);
  }
  return text;
}

Json jsonOf(const std::vector<TraversalRow>& rows, const ContextInfo& context) {
  Json list = Json::array();
  for (const TraversalRow& row : rows) list.push_back(jsonOf(row, context));
  return {{"gl_renderer", context.renderer},
          {"gl_version", context.version},
          {"cores", std::thread::hardware_concurrency()},
          {"measurements", list}};
}

}  // namespace glimt
