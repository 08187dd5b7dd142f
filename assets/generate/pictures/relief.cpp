#include "assets/generate/pictures/relief.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "assets/generate/geometry/random.h"

namespace glimt::assets {
namespace {

constexpr double kPi = std::numbers::pi;

std::uint8_t byteOf(double signed_unit) {
  return static_cast<std::uint8_t>(std::clamp(std::lround(127.5 + 127.5 * signed_unit), 0L, 255L));
}

// Where the grain's cell (x, y) has its middle, in cells.
dvec2 cellMiddle(int x, int y, int cells) {
  const int wrapped_x = (x + cells) % cells, wrapped_y = (y + cells) % cells;
  Random random(static_cast<std::uint64_t>(wrapped_y * cells + wrapped_x));
  const double dx = random.next();
  return {x + dx, y + random.next()};
}

}  // namespace

Picture normalMap(const std::string& name, int side,
                  const std::function<double(double, double)>& height) {
  Picture picture{name, side, side, {}};
  const double step = 0.5 / side;
  for (int y = 0; y < side; ++y)
    for (int x = 0; x < side; ++x) {
      const double u = (x + 0.5) / side, v = (y + 0.5) / side;
      const double by_u = (height(u + step, v) - height(u - step, v)) / (2 * step);
      const double by_v = (height(u, v + step) - height(u, v - step)) / (2 * step);
      const dvec3 normal = glm::normalize(dvec3(-by_u, by_v, 1));
      for (int k = 0; k < 3; ++k) picture.rgb.push_back(byteOf(normal[k]));
    }
  return picture;
}

double wovenHeight(double u, double v, int threads) {
  const double across = u * threads, along = v * threads;
  // Each thread is round, and rises where it passes over the other one.
  const double warp = std::abs(std::sin(kPi * across)), weft = std::abs(std::sin(kPi * along));
  const int checker = static_cast<int>(std::floor(across) + std::floor(along)) & 1;
  const double over = checker == 0 ? warp + 0.5 * weft : weft + 0.5 * warp;
  return 0.25 * over / threads;
}

double grainHeight(double u, double v, int cells) {
  const dvec2 p = dvec2(u - std::floor(u), v - std::floor(v)) * static_cast<double>(cells);
  double nearest = 9, second = 9;
  const int cell_x = static_cast<int>(p.x), cell_y = static_cast<int>(p.y);
  for (int y = cell_y - 2; y <= cell_y + 2; ++y)
    for (int x = cell_x - 2; x <= cell_x + 2; ++x) {
      const double distance = glm::length(cellMiddle(x, y, cells) - p);
      second = std::min(second, std::max(nearest, distance));
      nearest = std::min(nearest, distance);
    }
  return 0.35 * std::sqrt(std::min(1.0, 1.6 * (second - nearest))) / cells;
}

}  // namespace glimt::assets
