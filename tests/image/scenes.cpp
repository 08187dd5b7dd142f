#include "tests/image/scenes.h"

#include <cmath>

namespace glimt::test {
namespace {

void addSpherePatch(Scene& scene, const Vec3& a, const Vec3& b, const Vec3& c, float radius,
                    int levels, std::uint32_t material) {
  if (levels == 0) {
    addTriangle(scene, radius * a, radius * b, radius * c, material);
    return;
  }
  const Vec3 ab = glm::normalize(a + b);
  const Vec3 bc = glm::normalize(b + c);
  const Vec3 ca = glm::normalize(c + a);
  addSpherePatch(scene, a, ab, ca, radius, levels - 1, material);
  addSpherePatch(scene, ab, b, bc, radius, levels - 1, material);
  addSpherePatch(scene, ca, bc, c, radius, levels - 1, material);
  addSpherePatch(scene, ab, bc, ca, radius, levels - 1, material);
}

}  // namespace

void addTriangle(Scene& scene, const Vec3& a, const Vec3& b, const Vec3& c,
                 std::uint32_t material) {
  const auto first = static_cast<std::uint32_t>(scene.positions.size());
  scene.positions.insert(scene.positions.end(), {a, b, c});
  Triangle triangle;
  triangle.positions = {first, first + 1, first + 2};
  triangle.material = material;
  scene.triangles.push_back(triangle);
}

Material lambert(const std::string& name, const Vec3& base_color, const Vec3& emission) {
  Material material;
  material.name = name;
  material.base_color = base_color;
  material.emission = emission;
  return material;
}

std::uint32_t add(Scene& scene, const Material& material) {
  scene.materials.push_back(material);
  return static_cast<std::uint32_t>(scene.materials.size() - 1);
}

void addQuad(Scene& scene, const Vec3& corner, const Vec3& edge1, const Vec3& edge2,
             std::uint32_t material) {
  addTriangle(scene, corner, corner + edge1, corner + edge1 + edge2, material);
  addTriangle(scene, corner, corner + edge1 + edge2, corner + edge2, material);
}

void addCube(Scene& scene, float half_width, std::uint32_t material, bool inwards) {
  const float w = half_width;
  for (int axis = 0; axis < 3; ++axis) {
    for (const float side : {-1.0f, 1.0f}) {
      Vec3 corner(-w);
      corner[axis] = side * w;
      Vec3 edge1(0);
      Vec3 edge2(0);
      edge1[(axis + 1) % 3] = 2 * w;
      edge2[(axis + 2) % 3] = 2 * w;
      if ((side > 0) == inwards) std::swap(edge1, edge2);
      addQuad(scene, corner, edge1, edge2, material);
    }
  }
}

void addSphere(Scene& scene, float radius, int levels, std::uint32_t material) {
  for (const float x : {-1.0f, 1.0f})
    for (const float y : {-1.0f, 1.0f})
      for (const float z : {-1.0f, 1.0f}) {
        const Vec3 a(x, 0, 0);
        Vec3 b(0, y, 0);
        Vec3 c(0, 0, z);
        if (x * y * z < 0) std::swap(b, c);
        addSpherePatch(scene, a, b, c, radius, levels, material);
      }
}

Scene furnace(float albedo) {
  Scene scene;
  addCube(scene, 1, add(scene, lambert("wall", Vec3(albedo), Vec3(1))), true);
  scene.camera.position = Vec3(0.3f, -0.2f, 0.9f);
  scene.camera.target = Vec3(-0.2f, 0.1f, 0);
  scene.camera.vertical_fov = 80;
  return scene;
}

double furnaceRadiance(double albedo, int bounces) {
  double sum = 0;
  for (int k = 0; k <= bounces + 1; ++k) sum += std::pow(albedo, k);
  return sum;
}

}  // namespace glimt::test
