#include "renderer/passes/texture_packing.h"

#include <stb_rect_pack.h>

#include <algorithm>
#include <bit>
#include <cmath>

namespace glimt {
namespace {

constexpr std::uint64_t kBytes = 4;  // a texel

std::uint64_t areaOf(const AtlasRectangle& r) {
  return static_cast<std::uint64_t>(r.width) * static_cast<std::uint64_t>(r.height);
}

// True where all fit into an atlas of that width; then they are placed, and `height` is what they
// take.
bool place(std::vector<AtlasRectangle>& rectangles, int width, int most_height, int& height) {
  std::vector<stbrp_rect> rects;
  for (std::size_t i = 0; i < rectangles.size(); ++i)
    if (rectangles[i].width > 0)
      rects.push_back({static_cast<int>(i), rectangles[i].width, rectangles[i].height, 0, 0, 0});
  std::vector<stbrp_node> nodes(static_cast<std::size_t>(width));
  stbrp_context context;
  stbrp_init_target(&context, width, most_height, nodes.data(), width);
  if (!stbrp_pack_rects(&context, rects.data(), static_cast<int>(rects.size()))) return false;
  height = 0;
  for (const stbrp_rect& rect : rects) {
    AtlasRectangle& rectangle = rectangles[static_cast<std::size_t>(rect.id)];
    rectangle.x = rect.x;
    rectangle.y = rect.y;
    height = std::max(height, rect.y + rect.h);
  }
  return true;
}

// The widths that are tried are powers of two and three steps between, from about the side of a
// square on.
bool placeAll(AtlasPlan& plan, int most_side, std::uint64_t most_bytes) {
  std::uint64_t area = 0;
  int widest = 1;
  int highest = 1;
  for (const AtlasRectangle& rectangle : plan.rectangles) {
    area += areaOf(rectangle);
    widest = std::max(widest, rectangle.width);
    highest = std::max(highest, rectangle.height);
  }
  if (area * kBytes > most_bytes || std::max(widest, highest) > most_side) return false;
  const auto side = static_cast<unsigned>(std::sqrt(static_cast<double>(area)));
  std::uint64_t start = std::bit_ceil(std::max(side, static_cast<unsigned>(widest)));
  for (std::uint64_t quarters = 4;; ++quarters) {
    if (quarters == 8) {
      start *= 2;
      quarters = 4;
    }
    const std::uint64_t next = start * quarters / 4;
    const int width =
        static_cast<int>(std::min<std::uint64_t>(next, static_cast<unsigned>(most_side)));
    const std::uint64_t rows = most_bytes / kBytes / static_cast<unsigned>(width);
    const int most_height =
        static_cast<int>(std::min<std::uint64_t>(rows, static_cast<unsigned>(most_side)));
    if (most_height >= highest && place(plan.rectangles, width, most_height, plan.height)) {
      plan.width = width;
      return true;
    }
    if (width == most_side) return false;
  }
}

void halveLargest(AtlasPlan& plan) {
  const auto largest = std::max_element(
      plan.rectangles.begin(), plan.rectangles.end(),
      [](const AtlasRectangle& a, const AtlasRectangle& b) { return areaOf(a) < areaOf(b); });
  largest->width = (largest->width + 1) / 2;
  largest->height = (largest->height + 1) / 2;
  ++plan.halvings[static_cast<std::size_t>(largest - plan.rectangles.begin())];
}

}  // namespace

AtlasPlan planAtlas(const std::vector<AtlasRectangle>& sizes, int most_side,
                    std::uint64_t most_bytes) {
  AtlasPlan plan;
  plan.rectangles = sizes;
  plan.halvings.resize(sizes.size());
  const bool any = std::any_of(sizes.begin(), sizes.end(),
                               [](const AtlasRectangle& size) { return size.width > 0; });
  if (!any) return plan;
  while (!placeAll(plan, most_side, most_bytes)) halveLargest(plan);
  return plan;
}

}  // namespace glimt
