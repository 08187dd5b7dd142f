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

Json jsonOf(const Spread& spread) {
  return {{"median", rounded(spread.median)},
          {"least", rounded(spread.least)},
          {"most", rounded(spread.most)}};
}

Json jsonOf(const PassesRow& row, const ContextInfo& context) {
  Json json{{"suite", "passes"},      {"scene", row.scene},     {"triangles", row.triangles},
            {"bounces", row.bounces}, {"variant", row.variant}, {"traversal", row.traversal},
            {"gles", context.gles}};
  json["compile_seconds"] = jsonOf(row.compile_seconds);
  json["sample_seconds"] = row.sample_seconds ? jsonOf(*row.sample_seconds) : Json(nullptr);
  json["agrees"] = row.agrees ? Json(*row.agrees) : Json(nullptr);
  if (!row.note.empty()) json["note"] = row.note;
  return json;
}

void addSpread(Json& json, const std::string& key, const std::optional<Spread>& spread) {
  json[key] = spread ? Json(rounded(spread->median)) : Json(nullptr);
  json[key + "_least"] = spread ? Json(rounded(spread->least)) : Json(nullptr);
  json[key + "_most"] = spread ? Json(rounded(spread->most)) : Json(nullptr);
}

Json jsonOf(const EffectsRow& row, const ContextInfo& context) {
  Json json{{"suite", "effects"},     {"scene", row.scene},         {"triangles", row.triangles},
            {"bounces", row.bounces}, {"traversal", row.traversal}, {"gles", context.gles},
            {"effect", row.effect},   {"forced", row.forced},       {"withheld", row.withheld}};
  addSpread(json, "compile_seconds", row.compile_seconds);
  addSpread(json, "seconds_per_sample", row.sample_seconds);
  addSpread(json, "ratio", row.ratio);
  json["agrees"] = row.agrees ? Json(*row.agrees) : Json(nullptr);
  if (!row.note.empty()) json["note"] = row.note;
  return json;
}

template <typename Row>
Json reportOf(const std::vector<Row>& rows, const BenchConditions& conditions) {
  Json list = Json::array();
  for (const Row& row : rows) list.push_back(jsonOf(row, conditions.context));
  return {{"gl_renderer", conditions.context.renderer},
          {"gl_version", conditions.context.version},
          {"cores", std::thread::hardware_concurrency()},
          {"side", conditions.side},
          {"measurements", list}};
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

std::string textOf(const PassesRow& row) {
  std::string text = fmt::format("{:<9} ", row.variant);
  if (!row.sample_seconds) return text + row.note;
  const Spread& sample = *row.sample_seconds;
  const std::string spread =
      fmt::format("{:.4f} [{:.4f} {:.4f}]", sample.median, sample.least, sample.most);
  const char* const agrees = row.variant == kPasses ? "reference" : (*row.agrees ? "yes" : "NO");
  text += fmt::format("{:>8.2f}  {:<24} {}", *row.compile_seconds, spread, agrees);
  return row.note.empty() ? text : text + "; " + row.note;
}

std::string textOf(const std::optional<Spread>& spread, int decimals) {
  if (!spread) return "";
  return fmt::format("{1:.{0}f} [{2:.{0}f} {3:.{0}f}]", decimals, spread->median, spread->least,
                     spread->most);
}

std::string agreementOf(const EffectsRow& row) {
  if (row.effect == kOwnEffects) return "reference";
  if (!row.agrees) return "another picture";
  return *row.agrees ? "yes" : "NO";
}

std::string textOf(const EffectsRow& row) {
  std::string text = fmt::format("{:<21}", row.effect);
  if (row.sample_seconds) {
    text += fmt::format("{:<17} {:<24} {:<17} {}", textOf(row.compile_seconds, 2),
                        textOf(row.sample_seconds, 4), textOf(row.ratio, 2), agreementOf(row));
  }
  return row.note.empty() ? text : text + "; " + row.note;
}

}  // namespace

std::string textOf(const std::vector<TraversalRow>& rows, const BenchConditions& conditions) {
  std::string text = fmt::format("{}, {}\nmillion rays per second: median [least most]\n",
                                 conditions.context.renderer, conditions.context.version);
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

std::string textOf(const std::vector<PassesRow>& rows, const BenchConditions& conditions) {
  std::string text = fmt::format(
      "{}, {}\n{} x {} pixels, seconds per sample: median [least most]\n",
      conditions.context.renderer, conditions.context.version, conditions.side, conditions.side);
  const PassesRow* last = nullptr;
  for (const PassesRow& row : rows) {
    const bool other_scene =
        last == nullptr || row.scene != last->scene || row.triangles != last->triangles;
    if (other_scene)
      text += fmt::format("\n{}, {}, traversal {}\n  {:<8} {:<9} {:>8}  {:<24} {}\n", row.scene,
                          counted(row.triangles, "triangle"), row.traversal, "bounces", "variant",
                          "compile", "sample", "agrees");
    text += fmt::format("  {:<8} {}\n", row.variant == kPasses ? fmt::to_string(row.bounces) : "",
                        textOf(row));
    last = &row;
  }
  return text;
}

std::string textOf(const std::vector<EffectsRow>& rows, const BenchConditions& conditions) {
  const EffectsRow& own = rows.front();
  std::string text = fmt::format(
      "{}, {}\n{} x {} pixels, seconds: median [least most]\n\n{}, {}, {}, traversal {}\n",
      conditions.context.renderer, conditions.context.version, conditions.side, conditions.side,
      printable(own.scene), counted(own.triangles, "triangle"),
      counted(static_cast<std::uintmax_t>(own.bounces), "bounce"), own.traversal);
  text += fmt::format("  {:<21}{:<17} {:<24} {:<17} {}\n", "effects", "compile", "sample", "ratio",
                      "agrees");
  for (const EffectsRow& row : rows) text += fmt::format("  {}\n", textOf(row));
  return text;
}

Json jsonOf(const std::vector<TraversalRow>& rows, const BenchConditions& conditions) {
  return reportOf(rows, conditions);
}

Json jsonOf(const std::vector<PassesRow>& rows, const BenchConditions& conditions) {
  return reportOf(rows, conditions);
}

Json jsonOf(const std::vector<EffectsRow>& rows, const BenchConditions& conditions) {
  return reportOf(rows, conditions);
}

}  // namespace glimt
