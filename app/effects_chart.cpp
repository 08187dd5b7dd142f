#include <fmt/format.h>

#include <algorithm>

#include "app/bench_chart.h"
#include "app/chart.h"
#include "renderer/core/wording.h"

namespace glimt {
namespace {

constexpr double kPanelHeight = 250;
constexpr double kNamesHeight = 104;  // under the bars of the lower panel
constexpr double kAxisWidth = 56;
constexpr double kGapBetweenBars = 8;
constexpr std::size_t kOwnColor = 0;
constexpr std::size_t kLessColor = 2;
constexpr std::size_t kOneColor = 1;
constexpr std::size_t kAllColor = 5;

using Rows = std::vector<EffectsRow>;
using Value = std::optional<Spread> EffectsRow::*;

std::size_t colorOf(const EffectsRow& row) {
  if (row.effect == kOwnEffects) return kOwnColor;
  if (!row.withheld.empty()) return kLessColor;
  return row.effect == kAllEffects ? kAllColor : kOneColor;
}

class EffectsChart {
 public:
  EffectsChart(const Rows& rows, const BenchConditions& conditions)
      : rows_(&rows),
        top_(headingHeight(keys())),
        svg_(kChartWidth, top_ + 2 * kPanelHeight + kNamesHeight) {
    drawHeading(
        svg_, title(), conditions,
        "pixels; bars: median of the repeats, whiskers: least and most, cut off; lower is faster",
        keys());
    drawPanel(0, "seconds per sample, and how many times those of the scene's own effects",
              &EffectsRow::sample_seconds);
    const double names = drawPanel(1, "seconds to compile", &EffectsRow::compile_seconds);
    for (std::size_t i = 0; i < rows.size(); ++i)
      svg_.text({middleOf(i) + 4, names + 14}, rows[i].effect, {12, "#222222", "end", false, -50});
  }

  std::string file() const { return svg_.file(); }

 private:
  static std::vector<ChartKey> keys() {
    return {{"the scene's own effects", chartColor(kOwnColor)},
            {"without one of them", chartColor(kLessColor)},
            {"one more effect forced on", chartColor(kOneColor)},
            {"all effects", chartColor(kAllColor)}};
  }

  std::string title() const {
    const EffectsRow& own = rows_->front();
    return fmt::format("What effects cost: {}, {}, {}", printable(own.scene),
                       counted(own.triangles, "triangle"),
                       counted(static_cast<std::uintmax_t>(own.bounces), "bounce"));
  }

  // Returns where the axis of names is.
  double drawPanel(int row, const std::string& what, Value value) {
    const double y = top_ + kPanelHeight * row;
    const Plot plot({left(), y + 34}, {kChartWidth - kChartMargin, y + kPanelHeight - 12},
                    mostOf(value));
    svg_.text({plot.left(), y + 20}, what, {13, "#222222", "start", true});
    plot.drawGrid(svg_);
    for (std::size_t i = 0; i < rows_->size(); ++i) drawBar(plot, i, value);
    return plot.bottom();
  }

  // A single slow moment must not press all bars down: whiskers may be longer than the panel.
  double mostOf(Value value) const {
    double most = 0;
    double most_median = 0;
    for (const EffectsRow& row : *rows_) {
      if (!(row.*value)) continue;
      most = std::max(most, (row.*value)->most);
      most_median = std::max(most_median, (row.*value)->median);
    }
    return std::min(most, 1.25 * most_median) * 1.1;  // room for a number above the bar
  }

  static double left() { return kChartMargin + kAxisWidth; }

  double step() const {
    return (kChartWidth - kChartMargin - left()) / static_cast<double>(rows_->size());
  }

  double middleOf(std::size_t bar) const {
    return left() + step() * (static_cast<double>(bar) + 0.5);
  }

  void drawBar(const Plot& plot, std::size_t bar, Value value) {
    const EffectsRow& row = (*rows_)[bar];
    const double x = middleOf(bar);
    if (!(row.*value)) {
      svg_.text({x + 4, plot.bottom() - 8}, "refused",
                {11, chartColor(colorOf(row)), "start", false, -90});
      return;
    }
    const Spread& spread = *(row.*value);
    const double half = (step() - kGapBetweenBars) / 2;
    svg_.rectangle({x - half, plot.yOf(spread.median)}, {x + half, plot.bottom()},
                   chartColor(colorOf(row)));
    const double most = std::min(spread.most, mostOf(value) / 1.1);
    plot.drawWhisker(svg_, x, {spread.median, spread.least, most});
    if (value == &EffectsRow::sample_seconds)
      svg_.text({x, plot.yOf(most) - 4}, fmt::format("{:.2f}", row.ratio->median),
                {10.5, "#222222", "middle"});
  }

  const Rows* rows_;
  double top_;  // of the first panel
  Svg svg_;
};

}  // namespace

std::string chartOf(const std::vector<EffectsRow>& rows, const BenchConditions& conditions) {
  return EffectsChart(rows, conditions).file();
}

}  // namespace glimt
