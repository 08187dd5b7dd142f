#include "app/chart.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "renderer/core/wording.h"

namespace glimt {
namespace {

constexpr int kMostGridLines = 5;
constexpr double kWhiskerHalfWidth = 2.5;
constexpr std::string_view kGridColor = "#dddddd";
constexpr std::string_view kQuietColor = "#555555";
constexpr double kSmallText = 12;
constexpr double kMarkRadius = 4.5;
constexpr double kMarkToText = 9;
constexpr double kKeyLine = 19;
constexpr double kLetterWidth = 7.2;  // at most, on average, of small text

// The smallest of 1, 2 and 5 times a power of ten with which few enough lines reach `most`.
double roundStep(double most) {
  const double least = std::max(most, 1e-12) / kMostGridLines;
  const double power = std::pow(10, std::floor(std::log10(least)));
  for (const double factor : {1.0, 2.0, 5.0})
    if (factor * power >= least) return factor * power;
  return 10 * power;
}

// Centres of the keys' marks.
std::vector<Point> placesOf(const std::vector<ChartKey>& keys) {
  std::vector<Point> places;
  Point next{kChartMargin + 5, 83};
  for (const ChartKey& key : keys) {
    const double width = kLetterWidth * static_cast<double>(key.name.size());
    if (next.x + kMarkToText + width > kChartWidth - kChartMargin)
      next = {kChartMargin + 5, next.y + kKeyLine};
    places.push_back(next);
    next.x += kMarkToText + width + 25;
  }
  return places;
}

}  // namespace

Plot::Plot(const Point& top_left, const Point& bottom_right, double most)
    : top_left_(top_left),
      bottom_right_(bottom_right),
      step_(roundStep(most)),
      high_(std::max(most * 1.04, step_)) {}

double Plot::yOf(double value) const {
  return bottom() - (bottom() - top()) * value / high_;
}

void Plot::drawGrid(Svg& svg) const {
  for (int i = 0; i * step_ <= high_; ++i) {
    const double y = yOf(i * step_);
    svg.line({left(), y}, {right(), y}, {i == 0 ? kQuietColor : kGridColor, 1});
    // Rounded, since 3 * 0.1 is not 0.3.
    svg.text({left() - 6, y + 4}, fmt::format("{:.6g}", i * step_),
             {kSmallText, kQuietColor, "end"});
  }
}

void Plot::drawWhisker(Svg& svg, double x, const Spread& spread) const {
  const LineStyle style{"#222222", 1};
  const double low = yOf(spread.least);
  const double high = yOf(spread.most);
  svg.line({x, low}, {x, high}, style);
  for (const double y : {low, high})
    svg.line({x - kWhiskerHalfWidth, y}, {x + kWhiskerHalfWidth, y}, style);
}

void drawMark(Svg& svg, const Point& center, Mark mark, std::string_view color) {
  const auto [x, y] = center;
  const double r = kMarkRadius;
  switch (mark) {
    case Mark::square:
      svg.rectangle({x - r, y - r}, {x + r, y + r}, color);
      break;
    case Mark::circle:
      svg.circle(center, r, color);
      break;
    case Mark::triangle:
      svg.polygon({{x, y - 1.3 * r}, {x + 1.2 * r, y + r}, {x - 1.2 * r, y + r}}, color);
      break;
  }
}

void drawHeading(Svg& svg, const std::string& title, const BenchConditions& conditions,
                 const std::string& measured, const std::vector<ChartKey>& keys) {
  const std::string device = fmt::format("{}, {}", printable(conditions.context.renderer),
                                         printable(conditions.context.version));
  const TextStyle quiet{kSmallText, kQuietColor};
  svg.text({kChartMargin, 26}, title, {17, "#222222", "start", true});
  svg.text({kChartMargin, 46}, device, quiet);
  svg.text({kChartMargin, 63}, fmt::format("{0} x {0} {1}", conditions.side, measured), quiet);
  const std::vector<Point> places = placesOf(keys);
  for (std::size_t i = 0; i < keys.size(); ++i) {
    drawMark(svg, places[i], keys[i].mark, keys[i].color);
    svg.text({places[i].x + kMarkToText, places[i].y + 4}, keys[i].name, {kSmallText});
  }
}

double headingHeight(const std::vector<ChartKey>& keys) {
  return (keys.empty() ? 83 : placesOf(keys).back().y) + 17;
}

std::string_view chartColor(std::size_t index) {
  constexpr std::array<std::string_view, 10> kColors{"#0072b2", "#e69f00", "#009e73", "#cc79a7",
                                                     "#56b4e9", "#d55e00", "#332288", "#999933",
                                                     "#882255", "#44aa99"};
  return kColors[index % kColors.size()];
}

}  // namespace glimt
