// Pictures side by side in one texture.
#include "renderer/passes/texture_packing.h"

#include <catch2/catch.hpp>

#include <random>

using namespace glimt;

namespace {

constexpr std::uint64_t kPlenty = std::uint64_t{1} << 30;

bool overlap(const AtlasRectangle& a, const AtlasRectangle& b) {
  return a.x < b.x + b.width && b.x < a.x + a.width && a.y < b.y + b.height && b.y < a.y + a.height;
}

void checkSound(const AtlasPlan& plan, int most_side) {
  CHECK(std::max(plan.width, plan.height) <= most_side);
  for (std::size_t i = 0; i < plan.rectangles.size(); ++i) {
    const AtlasRectangle& r = plan.rectangles[i];
    CHECK((r.x >= 0 && r.y >= 0 && r.x + r.width <= plan.width && r.y + r.height <= plan.height));
    for (std::size_t k = 0; k < i; ++k) CHECK_FALSE(overlap(r, plan.rectangles[k]));
  }
}

}  // namespace

TEST_CASE("pictures of all sizes lie in the atlas, apart, and none is made smaller without need") {
  std::mt19937 random(7);
  std::uniform_int_distribution<int> side(1, 300);
  std::vector<AtlasRectangle> sizes(60);
  for (AtlasRectangle& size : sizes) size = {0, 0, side(random), side(random)};
  const AtlasPlan plan = planAtlas(sizes, 4096, kPlenty);
  checkSound(plan, 4096);
  for (std::size_t i = 0; i < sizes.size(); ++i) {
    CHECK(plan.halvings[i] == 0);
    CHECK(plan.rectangles[i].width == sizes[i].width);
    CHECK(plan.rectangles[i].height == sizes[i].height);
  }
}

TEST_CASE("pictures that fill a square atlas exactly are kept") {
  const std::vector<AtlasRectangle> sizes(16, {0, 0, 64, 64});
  const AtlasPlan plan = planAtlas(sizes, 256, kPlenty);
  checkSound(plan, 256);
  CHECK(plan.rectangles.front().width == 64);
}

TEST_CASE("what does not fit is halved, the largest first, by side and by bytes") {
  const std::vector<AtlasRectangle> sizes{{0, 0, 1000, 300}, {0, 0, 100, 100}};
  const AtlasPlan by_side = planAtlas(sizes, 512, kPlenty);
  checkSound(by_side, 512);
  CHECK(by_side.halvings == std::vector<int>{1, 0});
  CHECK(by_side.rectangles[0].width == 500);
  const AtlasPlan by_bytes = planAtlas(sizes, 4096, 4 * 120000);
  checkSound(by_bytes, 4096);
  CHECK(by_bytes.halvings == std::vector<int>{1, 0});
  CHECK(static_cast<std::uint64_t>(by_bytes.width) * by_bytes.height * 4 <= 4 * 120000);
}

TEST_CASE("no picture, or none that is looked up, makes no atlas") {
  CHECK(planAtlas({}, 4096, kPlenty).width == 0);
  CHECK(planAtlas({{0, 0, 0, 0}}, 4096, kPlenty).width == 0);
}
