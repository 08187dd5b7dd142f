// A drawing as SVG text. Coordinates are in pixels, y downwards.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace glimt {

struct Point {
  double x = 0;
  double y = 0;
};

// Text in which XML and HTML read no markup.
std::string escapedMarkup(std::string_view text);

struct TextStyle {
  double size = 12;
  std::string_view color = "#222222";
  std::string_view anchor =
      "start";  // start, middle or end: which part of the text is at the point
  bool bold = false;
  double turn = 0;  // degrees clockwise around the point
};

struct LineStyle {
  std::string_view color = "#222222";
  double width = 1;
};

class Svg {
 public:
  // On white.
  Svg(double width, double height);

  // Any text: what XML would read as markup is escaped.
  void text(const Point& at, std::string_view text, const TextStyle& style = {});
  void line(const Point& from, const Point& to, const LineStyle& style = {});
  void polyline(const std::vector<Point>& points, const LineStyle& style);
  // Two opposite corners, in any order.
  void rectangle(const Point& corner, const Point& opposite, std::string_view color);
  void polygon(const std::vector<Point>& corners, std::string_view color);
  void circle(const Point& center, double radius, std::string_view color);

  // The file.
  std::string file() const;

 private:
  double width_;
  double height_;
  std::string body_;
};

}  // namespace glimt
