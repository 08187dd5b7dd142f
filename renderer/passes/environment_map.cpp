#include "renderer/passes/environment_map.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "renderer/core/error.h"
#include "renderer/passes/alias_table.h"

namespace glimt {
namespace {

// A random number has 23 bits, and choosing a cell takes these of them.
constexpr std::size_t kMostCells = std::size_t{1} << 19;

double brightness(const Vec3& radiance) {
  return (static_cast<double>(radiance.r) + radiance.g + radiance.b) / 3;
}

// Mean brightness of each pixel's square, neighbours blended in as bilinear lookups do: 1/8, 6/8,
// 1/8 in either direction, around the left and right edges.
std::vector<double> blended(const Image& image) {
  const int width = image.width;
  const int height = image.height;
  const auto at = [&](int x, int y) {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
           static_cast<std::size_t>(x);
  };
  std::vector<double> across(image.pixels.size());
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) {
      const double left = brightness(image.pixels[at((x + width - 1) % width, y)]);
      const double right = brightness(image.pixels[at((x + 1) % width, y)]);
      across[at(x, y)] = (left + 6 * brightness(image.pixels[at(x, y)]) + right) / 8;
    }
  std::vector<double> both(image.pixels.size());
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) {
      const double above = across[at(x, std::max(y - 1, 0))];
      const double below = across[at(x, std::min(y + 1, height - 1))];
      both[at(x, y)] = (above + 6 * across[at(x, y)] + below) / 8;
    }
  return both;
}

// How many pixels a side make a cell.
int cellSide(const Image& image, std::size_t most) {
  int side = 1;
  const auto cells = [&](int pixels) {
    return static_cast<std::size_t>((pixels + side - 1) / side);
  };
  while (cells(image.width) * cells(image.height) > most) ++side;
  return side;
}

std::size_t mostCells(const Environment& environment) {
  return environment.most_cells == 0 ? kMostCells : std::min(environment.most_cells, kMostCells);
}

}  // namespace

EnvironmentCells environmentCells(const Image& image, std::size_t most) {
  const int side = cellSide(image, most);
  EnvironmentCells cells;
  cells.width = std::max(image.width / side, 1);
  cells.height = std::max(image.height / side, 1);
  const auto count = static_cast<std::size_t>(cells.width) * static_cast<std::size_t>(cells.height);
  std::vector<double> sums(count);
  std::vector<double> pixels(count);
  const std::vector<double> brightnesses = blended(image);
  for (int y = 0; y < image.height; ++y)
    for (int x = 0; x < image.width; ++x) {
      const int column = x * cells.width / image.width;
      const int row = y * cells.height / image.height;
      const auto cell = static_cast<std::size_t>(row * cells.width + column);
      sums[cell] +=
          brightnesses[static_cast<std::size_t>(y) * static_cast<std::size_t>(image.width) +
                       static_cast<std::size_t>(x)];
      pixels[cell] += 1;
    }

  std::vector<double> weights(count);
  std::vector<double> solid_angles(count);
  double total = 0;
  for (std::size_t i = 0; i < count; ++i) {
    const double row = static_cast<double>(i / static_cast<std::size_t>(cells.width));
    const double top = std::cos(std::numbers::pi * row / cells.height);
    const double bottom = std::cos(std::numbers::pi * (row + 1) / cells.height);
    solid_angles[i] = (top - bottom) * 2 * std::numbers::pi / cells.width;
    weights[i] = sums[i] / pixels[i] * solid_angles[i];
    total += weights[i];
  }
  if (!(total > 0))
    throw Error(ErrorKind::input, "the environment's picture is black; name another or none");
  const std::vector<AliasEntry> aliases = buildAliasTable(weights);
  for (std::size_t i = 0; i < count; ++i)
    cells.texels.emplace_back(aliases[i].share, static_cast<float>(aliases[i].other),
                              static_cast<float>(weights[i] / total / solid_angles[i]), 0.0f);
  return cells;
}

EnvironmentMap::EnvironmentMap(const gl::Device& device, const Environment& environment,
                               const EffectSet& effects) {
  const Image even{1, 1, {Vec3(1)}};
  const bool varies = environment.shines() && !environment.image.pixels.empty();
  const Image& image = varies ? environment.image : even;
  if (!has(effects, Effect::environment_map)) {
    picture_ = gl::Texture::floats(device.gl(), device.floatForm(), 1, 1, {Vec4(0)});
    cells_ = gl::Texture::floats(device.gl(), device.floatForm(), 1, 1, {Vec4(0)});
    return;
  }
  const int most = device.maxTextureSize();
  if (std::max(image.width, image.height) > most)
    throw Error(
        ErrorKind::input,
        fmt::format("the environment's picture has {} x {} pixels, and textures here have at "
                    "most {} a side; make it smaller",
                    image.width, image.height, most));
  std::vector<Vec4> texels;
  texels.reserve(image.pixels.size());
  for (const Vec3& pixel : image.pixels) texels.emplace_back(pixel, 1);
  picture_ =
      gl::Texture::floats(device.gl(), device.floatForm(), image.width, image.height, texels);
  EnvironmentCells cells = environmentCells(image, mostCells(environment));
  cells_ =
      gl::Texture::floats(device.gl(), device.floatForm(), cells.width, cells.height, cells.texels);
  turn(environment);
}

void EnvironmentMap::turn(const Environment& environment) {
  scale_ = environment.shines() ? environment.radiance() : Vec3(0);
  const double angle = std::numbers::pi / 180 * environment.rotation;
  rotation_ = Vec2(std::cos(angle), std::sin(angle));
}

void EnvironmentMap::bind(gl::Program& program) const {
  program.set("uEnvironmentPicture", picture_);
  program.set("uEnvironmentSize", Vec2(picture_.width(), picture_.height()));
  program.set("uEnvironmentCells", cells_);
  program.set("uEnvironmentCellsSize", Vec2(cells_.width(), cells_.height()));
  program.set("uEnvironmentScale", scale_);
  program.set("uEnvironmentRotation", rotation_);
}

std::size_t EnvironmentMap::bytes() const {
  std::size_t texels = 0;
  for (const gl::Texture* texture : {&picture_, &cells_})
    texels +=
        static_cast<std::size_t>(texture->width()) * static_cast<std::size_t>(texture->height());
  return texels * sizeof(Vec4);
}

}  // namespace glimt
