#include "renderer/bench/chain_texture.h"

#include <fmt/format.h>

#include <bit>
#include <cstdint>
#include <numeric>
#include <random>

#include "renderer/core/error.h"

namespace glimt {
namespace {

// One cycle through all: Sattolo 1986, "An algorithm to generate a random cyclic permutation".
std::vector<std::uint32_t> makeCycle(std::size_t count) {
  std::vector<std::uint32_t> next(count);
  std::iota(next.begin(), next.end(), 0u);
  std::mt19937 random(17);
  for (std::size_t i = count - 1; i > 0; --i) std::swap(next[i], next[random() % i]);
  return next;
}

}  // namespace

gl::Texture makeChainTexture(const gl::Device& device, std::size_t bytes) {
  const std::size_t count = bytes / sizeof(Vec4);
  const std::size_t width = std::size_t{1} << std::bit_width(count) / 2;
  const std::size_t height = count / width;
  if (std::max(width, height) > static_cast<std::size_t>(device.maxTextureSize()))
    throw Error(ErrorKind::input,
                fmt::format("textures here have {} texels a side at most, and {} x {} were needed",
                            device.maxTextureSize(), width, height));
  std::vector<Vec4> texels;
  texels.reserve(count);
  for (const std::uint32_t next : makeCycle(count)) {
    const Vec2 at((static_cast<float>(next % width) + 0.5f) / static_cast<float>(width),
                  (static_cast<float>(next / width) + 0.5f) / static_cast<float>(height));
    texels.emplace_back(at, at);
  }
  return gl::Texture::floats(device.gl(), device.floatForm(), static_cast<int>(width),
                             static_cast<int>(height), texels);
}

}  // namespace glimt
