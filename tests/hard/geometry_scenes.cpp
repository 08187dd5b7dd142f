#include "tests/hard/geometry_scenes.h"

#include <cmath>

#include "tests/image/scenes.h"

namespace glimt::test {

Scene cornellBox() {
  Scene scene;
  const std::uint32_t white = add(scene, lambert("white", Vec3(0.73f)));
  const std::uint32_t red = add(scene, lambert("red", Vec3(0.63f, 0.06f, 0.05f)));
  const std::uint32_t green = add(scene, lambert("green", Vec3(0.14f, 0.45f, 0.09f)));
  Material light = lambert("light", Vec3(0.5f), Vec3(17, 12, 4));
  light.double_sided = false;
  addQuad(scene, Vec3(-1, -1, 1), Vec3(2, 0, 0), Vec3(0, 0, -2), white);
  addQuad(scene, Vec3(-1, 1, -1), Vec3(2, 0, 0), Vec3(0, 0, 2), white);
  addQuad(scene, Vec3(-1, -1, -1), Vec3(2, 0, 0), Vec3(0, 2, 0), white);
  addQuad(scene, Vec3(-1, -1, -1), Vec3(0, 2, 0), Vec3(0, 0, 2), red);
  addQuad(scene, Vec3(1, -1, -1), Vec3(0, 0, 2), Vec3(0, 2, 0), green);
  addQuad(scene, Vec3(-0.25f, 0.99f, -0.25f), Vec3(0.5f, 0, 0), Vec3(0, 0, 0.5f),
          add(scene, light));
  addBlock(scene, Vec3(0.05f, -1, 0), Vec3(0.65f, -0.4f, 0.6f), white);
  const std::size_t first = scene.positions.size();
  addBlock(scene, Vec3(-0.3f, -1, -0.3f), Vec3(0.3f, 0.2f, 0.3f), white);
  for (std::size_t i = first; i < scene.positions.size(); ++i) {
    const Vec3 p = scene.positions[i];
    scene.positions[i] =
        Vec3(0.9f * p.x + 0.43f * p.z - 0.35f, p.y, 0.9f * p.z - 0.43f * p.x - 0.3f);
  }
  scene.camera.position = Vec3(0, 0, 3.8f);
  return scene;
}

Scene shiningOutside(Scene scene) {
  scene.environment.color = Vec3(1);
  for (Material& material : scene.materials) material = lambert("wall", Vec3(1));
  return scene;
}

Scene transformed(Scene scene, float scale, const Vec3& offset) {
  for (Vec3& position : scene.positions) position = scale * position + offset;
  scene.camera.position = scale * scene.camera.position + offset;
  scene.camera.target = scale * scene.camera.target + offset;
  return scene;
}

void addBlock(Scene& scene, const Vec3& low, const Vec3& high, std::uint32_t material) {
  const std::size_t first = scene.positions.size();
  addCube(scene, 1, material);
  for (std::size_t i = first; i < scene.positions.size(); ++i) {
    const Vec3 corner = scene.positions[i];
    for (int axis = 0; axis < 3; ++axis)
      scene.positions[i][axis] = corner[axis] < 0 ? low[axis] : high[axis];
  }
}

void addStrips(Scene& scene, const Vec3& corner, const Vec3& edge1, const Vec3& edge2, int strips,
               std::uint32_t material) {
  const auto at = [&](int strip) {
    return corner + edge2 * (static_cast<float>(strip) / static_cast<float>(strips));
  };
  for (int strip = 0; strip < strips; ++strip) {
    const Vec3 a = at(strip);
    const Vec3 d = at(strip + 1);
    addTriangle(scene, a, a + edge1, d + edge1, material);
    addTriangle(scene, a, d + edge1, d, material);
  }
}

}  // namespace glimt::test
