#include "tests/image/textured_quad.h"

#include <cmath>

namespace glimt::test {
namespace {

constexpr float kFov = 40;
const float kDistance = 1 / std::tan(glm::radians(kFov / 2));

}  // namespace

std::uint32_t addPictureAt(Scene& scene, const Material& material, float z) {
  const std::uint32_t index = add(scene, material);
  const float half = (kDistance - z) / kDistance;
  const auto first = static_cast<std::uint32_t>(scene.texcoords.size());
  for (const Vec2 at : {Vec2(0, 1), Vec2(1, 1), Vec2(1, 0), Vec2(0, 0)})
    scene.texcoords.push_back({{at, Vec2(0)}});
  addQuad(scene, Vec3(-half, -half, z), Vec3(2 * half, 0, 0), Vec3(0, 2 * half, 0), index);
  const std::size_t count = scene.triangles.size();
  scene.triangles[count - 2].texcoords = {first, first + 1, first + 2};
  scene.triangles[count - 1].texcoords = {first, first + 2, first + 3};
  scene.camera.position = Vec3(0, 0, kDistance);
  scene.camera.target = Vec3(0);
  scene.camera.vertical_fov = kFov;
  return index;
}

std::uint32_t addPicture(Scene& scene, const Material& material) {
  return addPictureAt(scene, material, 0);
}

TextureUse addImage(Scene& scene, int width, int height, const std::vector<std::uint8_t>& rgba) {
  TextureUse use;
  use.image = static_cast<std::uint32_t>(scene.images.size());
  use.nearest = true;
  scene.images.push_back({"test", width, height, rgba});
  return use;
}

Material unlit() {
  Material material = lambert("unlit", Vec3(1));
  material.unlit = true;
  return material;
}

double linearOf(std::uint8_t srgb) {
  const double s = srgb / 255.0;
  return s <= 0.04045 ? s / 12.92 : std::pow((s + 0.055) / 1.055, 2.4);
}

}  // namespace glimt::test
