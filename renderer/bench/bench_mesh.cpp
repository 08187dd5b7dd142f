#include "renderer/bench/bench_mesh.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace glimt {
namespace {

using DVec3 = glm::dvec3;

constexpr std::size_t kRoomTriangles = 12;  // five walls and the light
constexpr double kRingsPerSide = 12;        // the tube is about as much longer than it is round
constexpr std::uint32_t kLightMaterial = 1;

struct TubeSize {
  std::uint32_t rings;
  std::uint32_t sides;
};

TubeSize tubeSizeFor(std::size_t triangles) {
  const std::size_t tube = triangles > kRoomTriangles ? triangles - kRoomTriangles : 0;
  const double quads = static_cast<double>(tube) / 2;
  const double sides = std::max(3.0, std::round(std::sqrt(quads / kRingsPerSide)));
  const double rings = std::max(3.0, std::round(quads / sides));
  return {static_cast<std::uint32_t>(rings), static_cast<std::uint32_t>(sides)};
}

DVec3 knotCurve(double s) {
  const double radius = 2 + std::cos(3 * s);
  return {radius * std::cos(2 * s), radius * std::sin(2 * s), std::sin(3 * s)};
}

// A point of the tube: `s` goes along the knot and `angle` around it.
Vec3 tubePoint(double s, double angle) {
  const DVec3 center = knotCurve(s);
  const DVec3 along = glm::normalize(knotCurve(s + 1e-4) - knotCurve(s - 1e-4));
  const DVec3 across = glm::normalize(glm::cross(along, center));
  const DVec3 up = glm::cross(across, along);
  const double radius = 0.35 + 0.08 * std::sin(20 * s + 3 * angle);
  return Vec3(center + radius * (std::cos(angle) * across + std::sin(angle) * up));
}

void addQuad(Scene& scene, const std::array<std::uint32_t, 4>& corners,
             std::uint32_t material = 0) {
  const auto [a, b, c, d] = corners;
  Triangle triangle;
  triangle.material = material;
  triangle.positions = {a, b, c};
  scene.triangles.push_back(triangle);
  triangle.positions = {a, c, d};
  scene.triangles.push_back(triangle);
}

void addTube(Scene& scene, const TubeSize& size) {
  const auto index = [&](std::uint32_t ring, std::uint32_t side) {
    return ring % size.rings * size.sides + side % size.sides;
  };
  constexpr double kTurn = 2 * std::numbers::pi;
  for (std::uint32_t ring = 0; ring < size.rings; ++ring)
    for (std::uint32_t side = 0; side < size.sides; ++side) {
      scene.positions.push_back(tubePoint(kTurn * ring / size.rings, kTurn * side / size.sides));
      addQuad(scene, {index(ring, side), index(ring + 1, side), index(ring + 1, side + 1),
                      index(ring, side + 1)});
    }
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
  addTube(scene, tubeSizeFor(triangles));
  addRoom(scene);
  addLight(scene);
  return scene;
}

}  // namespace glimt
