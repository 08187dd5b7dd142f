#include "renderer/bench/bench_mesh.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "renderer/bench/knot.h"

namespace glimt {
namespace {

constexpr std::size_t kRoomTriangles = 12;  // five walls and the light
constexpr double kRingsPerSide = 12;        // the tube is about as much longer than it is round
constexpr std::uint32_t kLightMaterial = 1;

KnotSize knotSizeFor(std::size_t triangles) {
  const std::size_t tube = triangles > kRoomTriangles ? triangles - kRoomTriangles : 0;
  const double quads = static_cast<double>(tube) / 2;
  const double sides = std::max(3.0, std::round(std::sqrt(quads / kRingsPerSide)));
  const double rings = std::max(3.0, std::round(quads / sides));
  return {static_cast<std::uint32_t>(rings), static_cast<std::uint32_t>(sides)};
}

void addRoom(Scene& scene) {
  constexpr std::array<std::array<std::uint32_t, 4>, 5> kWalls{
      {{0, 1, 3, 2}, {0, 1, 5, 4}, {2, 3, 7, 6}, {0, 2, 6, 4}, {1, 3, 7, 5}}};
  const auto first = static_cast<std::uint32_t>(scene.positions.size());
  for (int corner = 0; corner < 8; ++corner)
    scene.positions.emplace_back(corner & 1 ? 4 : -4, corner & 2 ? 4 : -4, corner & 4 ? 4 : -4);
  for (const auto& [a, b, c, d] : kWalls)
    addQuad(scene, {first + a, first + b, first + c, first + d});
}

void addLight(Scene& scene) {
  const auto first = static_cast<std::uint32_t>(scene.positions.size());
  for (int corner = 0; corner < 4; ++corner)
    scene.positions.emplace_back(corner & 1 ? kLightHalfSide : -kLightHalfSide, kLightHeight,
                                 corner & 2 ? kLightHalfSide : -kLightHalfSide);
  addQuad(scene, {first, first + 1, first + 3, first + 2}, kLightMaterial);
}

}  // namespace

Scene makeBenchMesh(std::size_t triangles) {
  Scene scene;
  scene.name = "knot";
  scene.materials.resize(2);
  scene.materials[kLightMaterial].emission = Vec3(10);
  scene.camera.position = {0, 0, 14};
  scene.camera.target = {0, 0, 0};
  scene.camera.up = {0, 1, 0};
  scene.camera.vertical_fov = 38;
  addKnot(scene, knotSizeFor(triangles));
  addRoom(scene);
  addLight(scene);
  return scene;
}

}  // namespace glimt
