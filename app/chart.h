// What the charts of all suites have in common.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "app/bench_conditions.h"
#include "app/svg.h"
#include "renderer/bench.h"

namespace glimt {

inline constexpr double kChartWidth = 900;
inline constexpr double kChartMargin = 16;

// A rectangle to draw values in, from zero at its bottom.
class Plot {
 public:
  // `most` is the largest value that will be drawn.
  Plot(const Point& top_left, const Point& bottom_right, double most);

  double left() const { return top_left_.x; }
  double right() const { return bottom_right_.x; }
  double top() const { return top_left_.y; }
  double bottom() const { return bottom_right_.y; }

  // In the picture.
  double yOf(double value) const;

  // Lines at round values, and what they are.
  void drawGrid(Svg& svg) const;

  // From the least to the most of the repeats.
  void drawWhisker(Svg& svg, double x, const Spread& spread) const;

 private:
  Point top_left_;
  Point bottom_right_;
  double step_;  // between lines
  double high_;  // value at the top
};

// Shapes differ too, for prints without colour.
enum class Mark { square, circle, triangle };

void drawMark(Svg& svg, const Point& center, Mark mark, std::string_view color);

struct ChartKey {
  std::string name;
  std::string_view color;
  Mark mark = Mark::square;
};

// Where the first panel begins below a heading with these keys, which take as many lines as they
// need.
double headingHeight(const std::vector<ChartKey>& keys);

// Title, device and version, and what was measured and drawn, such as "rays of each kind; bars:
// ...", which follows the size; then what the marks mean.
void drawHeading(Svg& svg, const std::string& title, const BenchConditions& conditions,
                 const std::string& measured, const std::vector<ChartKey>& keys);

// Told apart with any kind of colour blindness: Okabe and Ito 2008, "Color Universal Design",
// without yellow, which is too pale for lines on white, and some of Tol's muted ones behind them.
std::string_view chartColor(std::size_t index);

}  // namespace glimt
