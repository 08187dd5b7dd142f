#include "renderer/passes/data_texture.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>

#include "renderer/core/error.h"
#include "renderer/core/wording.h"

namespace glimt {
namespace {

// texelAddress adds a half to the index, which a float does exactly below this.
constexpr std::size_t kAddressable = std::size_t{1} << 23;

// Rows stay short for as long as they can: in v, texel x of a row is at (x + 1/2) / width of the
// row's height, and a device with few bits below the texel would round the last of a long row up.
constexpr std::size_t kPreferredWidth = 256;

std::size_t longestSide(int max_texture_size) {
  return std::bit_floor(static_cast<std::size_t>(max_texture_size));
}

}  // namespace

std::size_t mostTexels(int max_texture_size) {
  const std::size_t side = longestSide(max_texture_size);
  return std::min(side * side, kAddressable);
}

gl::Texture makeDataTexture(const gl::Device& device, std::vector<Vec4> texels,
                            const std::string& what) {
  const std::size_t largest = longestSide(device.maxTextureSize());
  const std::size_t limit = mostTexels(device.maxTextureSize());
  if (texels.size() > limit)
    throw Error(ErrorKind::input,
                fmt::format("the scene's {} need {} texels, but {} fit into a texture here; use a "
                            "smaller model",
                            what, grouped(texels.size()), grouped(limit)));
  const std::size_t count = std::bit_ceil(std::max<std::size_t>(texels.size(), 1));
  std::size_t width = std::min(count, std::min(kPreferredWidth, largest));
  while (count / width > largest) width *= 2;
  texels.resize(count);
  return gl::Texture::floats(device.gl(), device.floatForm(), static_cast<int>(width),
                             static_cast<int>(count / width), texels);
}

}  // namespace glimt
