#include "app/batch/contact_sheet.h"

#include <fmt/format.h>

#include <algorithm>

#include "app/png_url.h"
#include "app/svg.h"
#include "renderer/core/image_rgba.h"
#include "renderer/core/srgb.h"
#include "renderer/core/wording.h"

namespace glimt {
namespace {

constexpr const char* kHead = R"html(<!doctype html>
<html lang="en"><head><meta charset="utf-8">
<meta name="viewport" content="width=device-width, initial-scale=1">
<title>{0}</title>
<style>
body {{ font: 14px/1.4 system-ui, sans-serif; color: #222; background: #fff; margin: 1.5em; }}
h1 {{ font-size: 1.3em; }}
table {{ border-collapse: collapse; }}
th {{ font-weight: 600; padding: .3em .6em; }}
tr > th:first-child {{ text-align: right; color: #555; font-weight: normal; white-space: nowrap; }}
td {{ padding: .3em; text-align: center; vertical-align: top; }}
img {{ display: block; margin: auto; background: repeating-conic-gradient(#e4e4e4 0 25%, #fff 0 50%) 0 0 / 16px 16px; }}
td span {{ color: #666; font-size: 12px; }}
</style></head><body>
<h1>{0}</h1>
<table>
)html";

std::string markup(const std::string& text) {
  return escapedMarkup(printable(text));
}

void addOnce(std::vector<std::string>& names, const std::string& name) {
  if (std::find(names.begin(), names.end(), name) == names.end()) names.push_back(name);
}

std::string cell(const ContactSheetPicture& picture) {
  // Names of files are made of letters, digits, dots and lines.
  const std::string image = picture.png.empty()
                                ? "<span>no picture</span>"
                                : fmt::format("<a href=\"{0}\"><img alt=\"{0}\" src=\"{1}\"></a>",
                                              markup(picture.file), pngUrl(picture.png));
  return fmt::format("<td>{}<span>{}</span></td>", image, markup(picture.note));
}

}  // namespace

Image shownImage(std::string_view png) {
  const RgbaImage rgba = decodeRgba(png);
  Image image{rgba.width, rgba.height, {}};
  for (std::size_t i = 0; i < rgba.bytes.size(); i += 4) {
    const float alpha = static_cast<float>(rgba.bytes[i + 3]) / 255;
    Vec3 color;
    for (int c = 0; c < 3; ++c)
      color[c] = static_cast<float>(linearOfSrgb(rgba.bytes[i + static_cast<std::size_t>(c)]));
    image.pixels.push_back(alpha * color);
    image.alpha.push_back(alpha);
  }
  return image;
}

Image reduced(const Image& image, int side) {
  const int step = std::max((std::max(image.width, image.height) + side - 1) / side, 1);
  Image small{(image.width + step - 1) / step, (image.height + step - 1) / step, {}};
  for (int y = 0; y < small.height; ++y) {
    for (int x = 0; x < small.width; ++x) {
      Vec4 sum(0);
      float count = 0;
      for (int j = step * y; j < std::min(step * (y + 1), image.height); ++j) {
        for (int i = step * x; i < std::min(step * (x + 1), image.width); ++i, ++count) {
          const std::size_t at = static_cast<std::size_t>(j) * image.width + i;
          sum += Vec4(image.pixels[at], image.alpha.empty() ? 1 : image.alpha[at]);
        }
      }
      small.pixels.emplace_back(sum / count);
      if (!image.alpha.empty()) small.alpha.push_back(sum.a / count);
    }
  }
  return small;
}

std::string contactSheet(const std::string& title,
                         const std::vector<ContactSheetPicture>& pictures) {
  std::vector<std::string> columns;
  std::vector<std::string> rows;
  for (const ContactSheetPicture& picture : pictures) {
    addOnce(columns, picture.column);
    addOnce(rows, picture.row);
  }
  std::string page = fmt::format(kHead, markup(title));
  page += "<tr><th></th>";
  for (const std::string& column : columns) page += fmt::format("<th>{}</th>", markup(column));
  page += "</tr>\n";
  for (const std::string& row : rows) {
    page += fmt::format("<tr><th>{}</th>", markup(row));
    for (const std::string& column : columns) {
      const auto found =
          std::find_if(pictures.begin(), pictures.end(), [&](const ContactSheetPicture& picture) {
            return picture.column == column && picture.row == row;
          });
      page += found == pictures.end() ? "<td></td>" : cell(*found);
    }
    page += "</tr>\n";
  }
  return page + "</table>\n</body></html>\n";
}

}  // namespace glimt
