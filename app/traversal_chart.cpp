#include <fmt/format.h>

#include <algorithm>

#include "app/bench_chart.h"
#include "app/chart.h"
#include "renderer/core/wording.h"

namespace glimt {
namespace {

constexpr double kPanelHeight = 270;
constexpr double kAxisWidth = 44;
constexpr double kGapBetweenGroups = 22;
constexpr double kGapBetweenBars = 1.5;
constexpr double kWidestBar = 34;
constexpr std::string_view kCeilingArea = "#eeeeee";
constexpr std::string_view kCeilingLine = "#000000";

// The rows of one mesh.
struct Mesh {
  std::size_t triangles = 0;
  const TraversalRow* ceiling = nullptr;
  std::vector<const TraversalRow*> bars;
};

std::vector<Mesh> meshesOf(const std::vector<TraversalRow>& rows) {
  std::vector<Mesh> meshes;
  for (const TraversalRow& row : rows) {
    if (meshes.empty() || meshes.back().triangles != row.triangles)
      meshes.push_back({row.triangles, nullptr, {}});
    if (!row.rates) continue;
    if (row.traversal == kEmbree)
      meshes.back().ceiling = &row;
    else
      meshes.back().bars.push_back(&row);
  }
  return meshes;
}

// In the order of the first mesh that has it.
std::vector<std::string> traversalsOf(const std::vector<TraversalRow>& rows) {
  std::vector<std::string> names;
  for (const TraversalRow& row : rows)
    if (row.rates && row.traversal != kEmbree &&
        std::find(names.begin(), names.end(), row.traversal) == names.end())
      names.push_back(row.traversal);
  return names;
}

class TraversalChart {
 public:
  TraversalChart(const std::vector<TraversalRow>& rows, const BenchConditions& conditions)
      : meshes_(meshesOf(rows)),
        names_(traversalsOf(rows)),
        columns_(meshes_.size() > 1 ? 2 : 1),
        top_(headingHeight(keys())),
        svg_(kChartWidth, top_ + kPanelHeight * rowCount() + 6) {
    drawHeading(svg_, "Million rays per second, by traversal", conditions,
                "rays of each kind; bars: median of the repeats, whiskers: least and most; higher "
                "is faster",
                keys());
    for (std::size_t i = 0; i < meshes_.size(); ++i) drawPanel(i);
  }

  std::string file() const { return svg_.file(); }

 private:
  double rowCount() const {
    return static_cast<double>((meshes_.size() + columns_ - 1) / columns_);
  }

  std::vector<ChartKey> keys() const {
    std::vector<ChartKey> keys;
    for (std::size_t i = 0; i < names_.size(); ++i) keys.push_back({names_[i], chartColor(i)});
    const auto capped = [](const Mesh& mesh) { return mesh.ceiling != nullptr; };
    if (std::any_of(meshes_.begin(), meshes_.end(), capped))
      keys.push_back({"Embree on the processor", kCeilingLine});
    return keys;
  }

  // All kinds of one mesh share an axis.
  void drawPanel(std::size_t index) {
    const Mesh& mesh = meshes_[index];
    const double width = (kChartWidth - 2 * kChartMargin) / static_cast<double>(columns_);
    const double x = kChartMargin + width * static_cast<double>(index % columns_);
    const double y = top_ + kPanelHeight * static_cast<double>(index / columns_);
    const Plot plot({x + kAxisWidth, y + 34}, {x + width - 12, y + kPanelHeight - 34},
                    mostOf(mesh));
    svg_.text({plot.left(), y + 20}, counted(mesh.triangles, "triangle"),
              {13, "#222222", "start", true});
    drawGroups(plot, mesh, true);
    plot.drawGrid(svg_);
    drawGroups(plot, mesh, false);
  }

  static double mostOf(const Mesh& mesh) {
    double most = 0;
    const auto include = [&](const TraversalRow& row) {
      for (const Rate& rate : *row.rates) most = std::max(most, rate.most);
    };
    for (const TraversalRow* row : mesh.bars) include(*row);
    if (mesh.ceiling != nullptr) include(*mesh.ceiling);
    return most;
  }

  // The areas below the ceiling are behind the grid, all else is in front of it.
  void drawGroups(const Plot& plot, const Mesh& mesh, bool behind) {
    const double kinds = static_cast<double>(kRayKinds.size());
    const double group = (plot.right() - plot.left() - kGapBetweenGroups * kinds) / kinds;
    for (std::size_t kind = 0; kind < kRayKinds.size(); ++kind) {
      const double left = plot.left() + kGapBetweenGroups / 2 +
                          (group + kGapBetweenGroups) * static_cast<double>(kind);
      const double right = left + group;
      if (behind && mesh.ceiling != nullptr)
        svg_.rectangle({left - 5, plot.yOf((*mesh.ceiling->rates)[kind].median)},
                       {right + 5, plot.bottom()}, kCeilingArea);
      if (behind) continue;
      drawBars(plot, mesh, kind, left, right);
      if (mesh.ceiling != nullptr) drawCeiling(plot, (*mesh.ceiling->rates)[kind], left, right);
      svg_.text({(left + right) / 2, plot.bottom() + 18}, fmt::format("{} rays", kRayKinds[kind]),
                {12, "#222222", "middle"});
    }
  }

  void drawBars(const Plot& plot, const Mesh& mesh, std::size_t kind, double left, double right) {
    const auto count = static_cast<double>(mesh.bars.size());
    const double width = std::min((right - left) / count, kWidestBar);
    double x = (left + right - width * count) / 2;
    for (const TraversalRow* row : mesh.bars) {
      const Rate& rate = (*row->rates)[kind];
      svg_.rectangle({x, plot.yOf(rate.median)}, {x + width - kGapBetweenBars, plot.bottom()},
                     colorOf(row->traversal));
      plot.drawWhisker(svg_, x + (width - kGapBetweenBars) / 2, rate);
      x += width;
    }
  }

  void drawCeiling(const Plot& plot, const Rate& rate, double left, double right) {
    const double y = plot.yOf(rate.median);
    svg_.line({left - 5, y}, {right + 5, y}, {kCeilingLine, 2.5});
    plot.drawWhisker(svg_, right + 2, rate);
  }

  std::string_view colorOf(const std::string& traversal) const {
    const auto found = std::find(names_.begin(), names_.end(), traversal);
    return chartColor(static_cast<std::size_t>(found - names_.begin()));
  }

  std::vector<Mesh> meshes_;
  std::vector<std::string> names_;
  std::size_t columns_;
  double top_;  // of the first panel
  Svg svg_;
};

}  // namespace

std::string chartOf(const std::vector<TraversalRow>& rows, const BenchConditions& conditions) {
  return TraversalChart(rows, conditions).file();
}

}  // namespace glimt
