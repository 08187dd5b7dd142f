#include "app/svg.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace glimt {
namespace {

// A tenth of a pixel is finer than anyone sees.
std::string pixels(double value) {
  return fmt::format("{:g}", std::round(value * 10) / 10);
}

std::string listOf(const std::vector<Point>& points) {
  std::string list;
  for (const Point& point : points)
    list += fmt::format("{}{},{}", list.empty() ? "" : " ", pixels(point.x), pixels(point.y));
  return list;
}

}  // namespace

std::string escapedMarkup(std::string_view text) {
  std::string result;
  for (const char c : text) {
    switch (c) {
      case '&':
        result += "&amp;";
        break;
      case '<':
        result += "&lt;";
        break;
      case '>':
        result += "&gt;";
        break;
      case '"':
        result += "&quot;";
        break;
      default:
        // Control characters are no part of XML, not even escaped.
        result += static_cast<unsigned char>(c) < 0x20 ? ' ' : c;
    }
  }
  return result;
}

Svg::Svg(double width, double height) : width_(width), height_(height) {
  rectangle({0, 0}, {width, height}, "#ffffff");
}

void Svg::text(const Point& at, std::string_view text, const TextStyle& style) {
  const std::string turn = style.turn == 0
                               ? ""
                               : fmt::format(" transform=\"rotate({} {} {})\"", pixels(style.turn),
                                             pixels(at.x), pixels(at.y));
  body_ += fmt::format(
      "<text x=\"{}\" y=\"{}\" font-size=\"{}\" fill=\"{}\" text-anchor=\"{}\"{}{}>{}</text>\n",
      pixels(at.x), pixels(at.y), pixels(style.size), style.color, style.anchor,
      style.bold ? " font-weight=\"bold\"" : "", turn, escapedMarkup(text));
}

void Svg::line(const Point& from, const Point& to, const LineStyle& style) {
  polyline({from, to}, style);
}

void Svg::polyline(const std::vector<Point>& points, const LineStyle& style) {
  body_ +=
      fmt::format("<polyline points=\"{}\" fill=\"none\" stroke=\"{}\" stroke-width=\"{}\"/>\n",
                  listOf(points), style.color, pixels(style.width));
}

void Svg::rectangle(const Point& corner, const Point& opposite, std::string_view color) {
  const auto [left, right] = std::minmax(corner.x, opposite.x);
  const auto [top, bottom] = std::minmax(corner.y, opposite.y);
  body_ +=
      fmt::format("<rect x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\" fill=\"{}\"/>\n",
                  pixels(left), pixels(top), pixels(right - left), pixels(bottom - top), color);
}

void Svg::polygon(const std::vector<Point>& corners, std::string_view color) {
  body_ += fmt::format("<polygon points=\"{}\" fill=\"{}\"/>\n", listOf(corners), color);
}

void Svg::circle(const Point& center, double radius, std::string_view color) {
  body_ += fmt::format("<circle cx=\"{}\" cy=\"{}\" r=\"{}\" fill=\"{}\"/>\n", pixels(center.x),
                       pixels(center.y), pixels(radius), color);
}

std::string Svg::file() const {
  return fmt::format(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{0}\" height=\"{1}\" viewBox=\"0 0 {0} "
      "{1}\" "
      "font-family=\"DejaVu Sans, Verdana, Arial, sans-serif\">\n{2}</svg>\n",
      pixels(width_), pixels(height_), body_);
}

}  // namespace glimt
