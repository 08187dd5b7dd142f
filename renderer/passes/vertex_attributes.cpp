#include "renderer/passes/vertex_attributes.h"

#include "renderer/passes/corner_order.h"
#include "shaders/layout.h"

namespace glimt {
namespace {

constexpr auto kTexels = static_cast<std::size_t>(TEXCOORD_TEXELS + COLOR_TEXELS);

void packTexcoords(const Scene& scene, const Triangle& triangle,
                   const std::array<std::size_t, 3>& corners, std::vector<Vec4>& texels) {
  std::array<TexCoords, 3> at;
  if (triangle.textured())
    for (std::size_t i = 0; i < 3; ++i) at[i] = scene.texcoords[triangle.texcoords[corners[i]]];
  texels.emplace_back(at[0].sets[0], at[1].sets[0]);
  texels.emplace_back(at[2].sets[0], at[2].sets[1]);
  texels.emplace_back(at[0].sets[1], at[1].sets[1]);
}

}  // namespace

std::vector<Vec4> packAttributes(const Scene& scene, const std::vector<std::uint32_t>& order,
                                 const EffectSet& effects) {
  const bool colored = has(effects, Effect::vertex_colors);
  std::vector<Vec4> texels;
  if (!colored && !has(effects, Effect::textures)) return texels;
  texels.reserve(order.size() * kTexels);
  for (const std::uint32_t index : order) {
    const Triangle& triangle = scene.triangles[index];
    const std::array<std::size_t, 3> corners = cornerOrder(scene, triangle);
    packTexcoords(scene, triangle, corners, texels);
    if (!colored) continue;
    for (const std::size_t corner : corners)
      texels.push_back(triangle.colored() ? scene.colors[triangle.colors[corner]] : Vec4(1));
  }
  return texels;
}

}  // namespace glimt
