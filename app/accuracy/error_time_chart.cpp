#include "app/accuracy/error_time_chart.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "app/chart.h"
#include "app/svg.h"

namespace glimt {
namespace {

constexpr double kWidth = 640;
constexpr double kHeight = 400;
constexpr double kLeft = 58;
constexpr double kRight = 16;
constexpr double kTop = 40;
constexpr double kBottom = kHeight - 46;
constexpr double kKeyLine = 18;
constexpr std::string_view kQuiet = "#555555";
constexpr std::string_view kGrid = "#e4e4e4";
constexpr std::string_view kDark = "#222222";

struct Range {
  double low = 1e300;
  double high = 0;

  void include(double value) {
    low = std::min(low, value);
    high = std::max(high, value);
  }
  double share(double value) const { return std::log(value / low) / std::log(high / low); }
};

// Round values within a range: 1, 2 and 5 times powers of ten.
std::vector<double> ticksOf(const Range& range) {
  std::vector<double> ticks;
  for (int power = static_cast<int>(std::floor(std::log10(range.low)));; ++power) {
    const double decade = std::pow(10.0, power);
    if (decade > range.high) return ticks;
    for (const double factor : {1.0, 2.0, 5.0})
      if (factor * decade >= range.low && factor * decade <= range.high)
        ticks.push_back(factor * decade);
  }
}

class ErrorTimeChart {
 public:
  ErrorTimeChart(const std::string& title, const std::vector<ChartCurve>& curves,
                 const std::vector<AccuracyPoint>& marked, const std::string& note)
      : svg_(kWidth, kHeight + kKeyLine * keyLines(curves.size() + (note.empty() ? 0 : 1))) {
    for (const ChartCurve& curve : curves)
      for (const AccuracyPoint& point : curve.points) {
        if (!(point.error > 0)) continue;
        times_.include(point.seconds);
        errors_.include(point.error);
      }
    if (times_.high == 0) times_ = errors_ = {0.1, 1};
    times_ = {times_.low / 1.15, times_.high * 1.15};
    errors_ = {errors_.low / 1.15, errors_.high * 1.15};
    svg_.text({kLeft, 22}, title, {15, kDark, "start", true});
    drawAxes();
    for (std::size_t i = curves.size(); i-- > 0;) drawCurve(curves[i], colorOf(i), i);
    for (const AccuracyPoint& point : marked) drawRing(at(point));
    if (!note.empty()) drawNote(note, curves.size());
  }

  std::string file() const { return svg_.file(); }

 private:
  static int keyLines(std::size_t keys) { return static_cast<int>((keys + 2) / 3); }
  static std::string_view colorOf(std::size_t i) { return i == 0 ? kDark : chartColor(i - 1); }

  Point at(const AccuracyPoint& point) const {
    return {kLeft + (kWidth - kLeft - kRight) * times_.share(point.seconds),
            kBottom - (kBottom - kTop) * errors_.share(point.error)};
  }

  static Point keyAt(std::size_t i) {
    return {kLeft + 8 + 190 * static_cast<double>(i % 3),
            kHeight + kKeyLine * (static_cast<double>(i / 3) + 0.3)};
  }

  void drawAxes() {
    for (const double seconds : ticksOf(times_)) {
      const double x = at({0, seconds, errors_.low}).x;
      svg_.line({x, kTop}, {x, kBottom}, {kGrid, 1});
      svg_.text({x, kBottom + 16}, fmt::format("{:.6g} s", seconds), {12, kQuiet, "middle"});
    }
    for (const double error : ticksOf(errors_)) {
      const double y = at({0, times_.low, error}).y;
      svg_.line({kLeft, y}, {kWidth - kRight, y}, {kGrid, 1});
      svg_.text({kLeft - 6, y + 4}, fmt::format("{:.6g}%", 100 * error), {12, kQuiet, "end"});
    }
    svg_.text({(kLeft + kWidth - kRight) / 2, kBottom + 34}, "time", {12, kQuiet, "middle"});
    svg_.text({14, (kTop + kBottom) / 2}, "error", {12, kQuiet, "middle", false, -90});
  }

  void drawCurve(const ChartCurve& curve, std::string_view color, std::size_t i) {
    std::vector<Point> points;
    for (const AccuracyPoint& point : curve.points)
      if (point.error > 0) points.push_back(at(point));
    svg_.polyline(points, {color, i == 0 ? 2.5 : 1.8});
    for (const Point& point : points) svg_.circle(point, 3, color);
    const Point key = keyAt(i);
    svg_.circle(key, 4, color);
    svg_.text({key.x + 9, key.y + 4}, curve.name, {12, kDark});
  }

  void drawRing(const Point& center) {
    std::vector<Point> ring;
    for (int i = 0; i <= 24; ++i) {
      const double angle = i * 2 * std::numbers::pi / 24;
      ring.push_back({center.x + 7 * std::cos(angle), center.y + 7 * std::sin(angle)});
    }
    svg_.polyline(ring, {"#d55e00", 1.6});
  }

  void drawNote(const std::string& note, std::size_t keys) {
    const Point key = keyAt(keys);
    drawRing(key);
    svg_.text({key.x + 13, key.y + 4}, note, {12, kDark});
  }

  Svg svg_;
  Range times_;
  Range errors_;
};

}  // namespace

std::string errorTimeChart(const std::string& title, const std::vector<ChartCurve>& curves,
                           const std::vector<AccuracyPoint>& marked, const std::string& note) {
  return ErrorTimeChart(title, curves, marked, note).file();
}

}  // namespace glimt
