#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "app/bench_chart.h"
#include "app/chart.h"
#include "renderer/core/wording.h"

namespace glimt {
namespace {

constexpr double kPanelHeight = 240;
constexpr double kAxisWidth = 56;
constexpr std::array kVariants{kPasses, kLoop, kUnrolled};
constexpr std::array kMarks{Mark::circle, Mark::square, Mark::triangle};
constexpr std::array kMeanings{"one pass per bounce", "one shader with a loop",
                               "one shader, bounces written out"};

using Rows = std::vector<const PassesRow*>;

std::vector<Rows> scenesOf(const std::vector<PassesRow>& rows) {
  std::vector<Rows> scenes;
  for (const PassesRow& row : rows) {
    if (scenes.empty() || scenes.back().front()->scene != row.scene ||
        scenes.back().front()->triangles != row.triangles)
      scenes.push_back({});
    scenes.back().push_back(&row);
  }
  return scenes;
}

// What a panel shows of a row; none where the driver refused the shader.
using Value = std::optional<Spread> (*)(const PassesRow&);

std::optional<Spread> sampleSeconds(const PassesRow& row) {
  return row.sample_seconds;
}

std::optional<Spread> compileSeconds(const PassesRow& row) {
  if (!row.compile_seconds) return std::nullopt;
  return Spread{*row.compile_seconds, *row.compile_seconds, *row.compile_seconds};
}

class PassesChart {
 public:
  PassesChart(const std::vector<PassesRow>& rows, const BenchConditions& conditions)
      : scenes_(scenesOf(rows)),
        top_(headingHeight(keys())),
        svg_(kChartWidth, top_ + 2 * kPanelHeight + 6) {
    drawHeading(svg_, "All bounces in one shader, or one pass per bounce", conditions,
                "pixels; points: median of the repeats, whiskers: least and most; lower is faster",
                keys());
    for (std::size_t column = 0; column < scenes_.size(); ++column) {
      drawPanel(column, 0, "seconds per sample", sampleSeconds);
      drawPanel(column, 1, "seconds to compile", compileSeconds);
    }
  }

  std::string file() const { return svg_.file(); }

 private:
  static std::vector<ChartKey> keys() {
    std::vector<ChartKey> keys;
    for (std::size_t i = 0; i < kVariants.size(); ++i)
      keys.push_back({fmt::format("{}: {}", kVariants[i], kMeanings[i]), chartColor(i), kMarks[i]});
    return keys;
  }

  void drawPanel(std::size_t column, int row, const std::string& what, Value value) {
    const Rows& rows = scenes_[column];
    const double width = (kChartWidth - 2 * kChartMargin) / static_cast<double>(scenes_.size());
    const double x = kChartMargin + width * static_cast<double>(column);
    const double y = top_ + kPanelHeight * row;
    const Plot plot({x + kAxisWidth, y + 34}, {x + width - 12, y + kPanelHeight - 40},
                    mostOf(rows, value));
    svg_.text({plot.left(), y + 20},
              fmt::format("{}, {}: {}", rows.front()->scene,
                          counted(rows.front()->triangles, "triangle"), what),
              {13, "#222222", "start", true});
    plot.drawGrid(svg_);
    drawBounces(plot, rows);
    // Those that come first are the more important ones: they are on top.
    for (std::size_t variant = kVariants.size(); variant-- > 0;)
      drawVariant(plot, rows, variant, value);
  }

  static double mostOf(const Rows& rows, Value value) {
    double most = 0;
    for (const PassesRow* row : rows)
      if (const auto spread = value(*row)) most = std::max(most, spread->most);
    return most;
  }

  static int mostBounces(const Rows& rows) {
    const auto fewer = [](const PassesRow* a, const PassesRow* b) {
      return a->bounces < b->bounces;
    };
    return (*std::max_element(rows.begin(), rows.end(), fewer))->bounces;
  }

  // From no bounces at the left to a little beyond the most at the right.
  static double xOf(const Plot& plot, const Rows& rows, int bounces) {
    return plot.left() + (plot.right() - plot.left()) * bounces / (mostBounces(rows) + 0.4);
  }

  void drawBounces(const Plot& plot, const Rows& rows) {
    for (const PassesRow* row : rows) {
      if (row->variant != kPasses) continue;
      svg_.text({xOf(plot, rows, row->bounces), plot.bottom() + 16},
                fmt::format("{}", row->bounces), {12, "#555555", "middle"});
    }
    svg_.text({(plot.left() + plot.right()) / 2, plot.bottom() + 32}, "secondary bounces",
              {12, "#555555", "middle"});
  }

  void drawVariant(const Plot& plot, const Rows& rows, std::size_t variant, Value value) {
    std::vector<Point> points;
    for (const PassesRow* row : rows) {
      if (row->variant != kVariants[variant]) continue;
      // Beside each other, so that whiskers do not hide each other.
      const double x = xOf(plot, rows, row->bounces) + 3 * (static_cast<double>(variant) - 1);
      if (const auto spread = value(*row)) {
        if (spread->least < spread->most) plot.drawWhisker(svg_, x, *spread);
        points.push_back({x, plot.yOf(spread->median)});
      } else {
        drawRefusal(plot, xOf(plot, rows, row->bounces), variant);
      }
    }
    svg_.polyline(points, {chartColor(variant), 2});
    for (const Point& point : points) drawMark(svg_, point, kMarks[variant], chartColor(variant));
  }

  // Upwards from the axis, the variants beside each other.
  void drawRefusal(const Plot& plot, double x, std::size_t variant) {
    svg_.text({x + 4 + 12 * (static_cast<double>(variant) - 1), plot.bottom() - 8}, "refused",
              {11, chartColor(variant), "start", false, -90});
  }

  std::vector<Rows> scenes_;
  double top_;  // of the first panel
  Svg svg_;
};

}  // namespace

std::string chartOf(const std::vector<PassesRow>& rows, const BenchConditions& conditions) {
  return PassesChart(rows, conditions).file();
}

}  // namespace glimt
