#include "assets/generate/pictures/wood.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "assets/generate/geometry/random.h"

namespace glimt::assets {
namespace {

// Smooth noise in [0, 1] that repeats after `columns` and `rows` cells.
double valueNoise(double x, double y, int columns, int rows, std::uint64_t seed) {
  const auto corner = [&](int i, int j) {
    const int wrapped_i = ((i % columns) + columns) % columns,
              wrapped_j = ((j % rows) + rows) % rows;
    return Random(seed * 1000003 + static_cast<std::uint64_t>(wrapped_j * columns + wrapped_i))
        .next();
  };
  const int i = static_cast<int>(std::floor(x)), j = static_cast<int>(std::floor(y));
  const double s = glm::smoothstep(0.0, 1.0, x - i), t = glm::smoothstep(0.0, 1.0, y - j);
  return glm::mix(glm::mix(corner(i, j), corner(i + 1, j), s),
                  glm::mix(corner(i, j + 1), corner(i + 1, j + 1), s), t);
}

std::uint8_t srgbByte(double linear) {
  const double v = linear <= 0.0031308 ? 12.92 * linear : 1.055 * std::pow(linear, 1 / 2.4) - 0.055;
  return static_cast<std::uint8_t>(std::clamp(std::lround(255 * v), 0L, 255L));
}

}  // namespace

Picture woodGrain(const std::string& name, int length) {
  const int width = length / 2;
  const dvec3 light(0.40, 0.235, 0.115), dark(0.17, 0.082, 0.034);
  Picture picture{name, width, length, {}};
  for (int y = 0; y < length; ++y)
    for (int x = 0; x < width; ++x) {
      const double u = (x + 0.5) / width, v = (y + 0.5) / length;
      const double drift =
          valueNoise(4 * u, 3 * v, 4, 3, 1) + 0.4 * valueNoise(9 * u, 7 * v, 9, 7, 2);
      const double rings = 0.5 + 0.5 * std::sin(2 * std::numbers::pi * (14 * u + 2.6 * drift));
      const double fibres = valueNoise(110 * u, 9 * v, 110, 9, 3),
                   pores = valueNoise(170 * u, 26 * v, 170, 26, 4);
      const double darkness =
          0.42 * std::pow(rings, 1.6) + 0.34 * fibres + (pores > 0.80 ? 0.30 : 0.0);
      const dvec3 color = glm::mix(light, dark, std::clamp(darkness, 0.0, 1.0));
      for (int k = 0; k < 3; ++k) picture.rgb.push_back(srgbByte(color[k]));
    }
  return picture;
}

}  // namespace glimt::assets
