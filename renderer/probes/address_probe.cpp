#include "renderer/probes/address_probe.h"

#include <algorithm>
#include <cmath>
#include <random>

#include "renderer/passes/data_texture.h"
#include "renderer/probes/probe.h"

namespace glimt {
namespace {

constexpr std::size_t kMostQueries = std::size_t{1} << 20;

constexpr const char* kFetch = R"(
uniform sampler2D uData;
uniform vec2 uDataStep;
vec4 probe(vec4 a) {
  vec2 at = texelAddress(a.x, uDataStep);
  return vec4(texture2D(uData, at).x, texture2D(uData, at + a.y * uDataStep).x, at);
})";

std::vector<Vec4> numbered(std::size_t count) {
  std::vector<Vec4> texels(count);
  for (std::size_t i = 0; i < count; ++i) texels[i] = Vec4(static_cast<float>(i), 7, 7, 7);
  return texels;
}

// An index, and how many steps further to look.
std::vector<Vec4> queries(std::size_t size) {
  std::mt19937 random(31);
  std::vector<Vec4> list(std::min(size, kMostQueries));
  for (std::size_t k = 0; k < list.size(); ++k) {
    // All, or as many from each end as in between.
    std::size_t i = k;
    if (size > kMostQueries && k >= kMostQueries / 3) i = random() % size;
    if (size > kMostQueries && k >= kMostQueries / 3 * 2) i = size - 1 - (k - kMostQueries / 3 * 2);
    list[k] = Vec4(static_cast<float>(i),
                   static_cast<float>(std::min<std::size_t>(i % 3, size - 1 - i)), 0, 0);
  }
  return list;
}

// Not only found, but found in the middle of the texel across and off its borders upwards, where
// devices may round as they like.
bool isRight(const Vec4& asked, const Vec4& found, int width, int height) {
  const double column = double(found.z) * width - asked.x;  // repeats once a row
  const double row = double(found.w) * height - std::floor(asked.x / static_cast<float>(width));
  return found.x == asked.x && found.y == asked.x + asked.y && column == 0.5 &&
         row >= 0.5 / width && row <= 1 - 0.5 / width;
}

}  // namespace

AddressProbe probeAddresses(const gl::Device& device, std::size_t size) {
  const gl::Texture texture = makeDataTexture(device, numbered(size), "numbers");
  const auto width = static_cast<float>(texture.width());
  const auto height = static_cast<float>(texture.height());
  const std::vector<Vec4> asked = queries(size);
  Probe probe(device, {"texel_address.glsl"}, kFetch);
  const std::vector<Vec4> found = probe.run({asked}, [&](gl::Program& program) {
    program.set("uData", texture);
    program.set("uDataStep", Vec2(1 / width, 1 / width / height));
  });
  AddressProbe result{asked.size(), 0};
  for (std::size_t k = 0; k < asked.size(); ++k)
    result.wrong += !isRight(asked[k], found[k], texture.width(), texture.height());
  return result;
}

}  // namespace glimt
