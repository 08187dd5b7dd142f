#include "app/viewer/outline.h"

#include <algorithm>
#include <array>

#include "renderer/pick.h"

namespace glimt {
namespace {

constexpr std::array<std::uint8_t, 4> kLine{255, 170, 40, 255};

// Whether the material is what each pixel shows.
std::vector<bool> maskOf(const LoadedScene& scene, const Camera& camera, std::size_t material,
                         int width, int height, const WorkProgress& progress) {
  const float aspect = static_cast<float>(width) / static_cast<float>(height);
  std::vector<bool> mask;
  mask.reserve(static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
  for (int y = 0; y < height; ++y) {
    progress(static_cast<float>(y) / static_cast<float>(height));
    for (int x = 0; x < width; ++x) {
      const Vec2 at((static_cast<float>(x) + 0.5f) / static_cast<float>(width),
                    (static_cast<float>(y) + 0.5f) / static_cast<float>(height));
      const auto hit = pick(scene.scene, scene.tree, rayThrough(camera, at, aspect));
      mask.push_back(hit && scene.scene.triangles[hit->triangle].material == material);
    }
  }
  return mask;
}

}  // namespace

Outline outlineOf(const LoadedScene& scene, const Camera& camera, std::size_t material, int width,
                  int height, const WorkProgress& progress) {
  const std::vector<bool> mask = maskOf(scene, camera, material, width, height, progress);
  Outline outline{width, height, std::vector<std::uint8_t>(4 * mask.size())};
  const auto inside = [&](int x, int y) {
    x = std::clamp(x, 0, width - 1);
    y = std::clamp(y, 0, height - 1);
    return mask[static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
                static_cast<std::size_t>(x)];
  };
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) {
      const bool edge = inside(x, y) && !(inside(x - 1, y) && inside(x + 1, y) &&
                                          inside(x, y - 1) && inside(x, y + 1));
      if (!edge) continue;
      const auto pixel = static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
                         static_cast<std::size_t>(x);
      std::copy(kLine.begin(), kLine.end(),
                outline.rgba.begin() + static_cast<std::ptrdiff_t>(4 * pixel));
    }
  return outline;
}

}  // namespace glimt
