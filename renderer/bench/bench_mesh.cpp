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
constexpr std::uint32_t kRed = 2;
constexpr std::uint32_t kGreen = 3;

// Corners of a cube's faces; bits 0, 1 and 2 of a corner say whether it is at the far end along x,
// y and z.
using Face = std::array<std::uint32_t, 4>;
constexpr Face kBack{0, 1, 3, 2};
constexpr Face kFloor{0, 1, 5, 4};
constexpr Face kCeiling{2, 3, 7, 6};
constexpr Face kLeft{0, 2, 6, 4};
constexpr Face kRight{1, 3, 7, 5};
constexpr Face kFront{4, 5, 7, 6};

KnotSize knotSizeFor(std::size_t triangles) {
  const std::size_t tube = triangles > kRoomTriangles ? triangles - kRoomTriangles : 0;
  const double quads = static_cast<double>(tube) / 2;
  const double sides = std::max(3.0, std::round(std::sqrt(quads / kRingsPerSide)));
  const double rings = std::max(3.0, std::round(quads / sides));
  return {static_cast<std::uint32_t>(rings), static_cast<std::uint32_t>(sides)};
}

// `size` is half its extent along its edges, `turn` how far it is turned around the y axis, in
// radians.
struct Block {
  Vec3 center;
  Vec3 size;
  float turn = 0;
};

// The index of its first corner.
std::uint32_t addCorners(Scene& scene, const Block& block) {
  const auto first = static_cast<std::uint32_t>(scene.positions.size());
  const float c = std::cos(block.turn);
  const float s = std::sin(block.turn);
  for (int corner = 0; corner < 8; ++corner) {
    const Vec3 p = block.size * Vec3(corner & 1 ? 1 : -1, corner & 2 ? 1 : -1, corner & 4 ? 1 : -1);
    scene.positions.push_back(block.center + Vec3(c * p.x + s * p.z, p.y, c * p.z - s * p.x));
  }
  return first;
}

void addFace(Scene& scene, std::uint32_t first, const Face& face, std::uint32_t material = 0) {
  addQuad(scene, {first + face[0], first + face[1], first + face[2], first + face[3]}, material);
}

void addBlock(Scene& scene, const Block& block) {
  const std::uint32_t first = addCorners(scene, block);
  for (const Face& face : {kBack, kFloor, kCeiling, kLeft, kRight, kFront})
    addFace(scene, first, face);
}

// Returns the first of its corners. The side towards the camera is open.
std::uint32_t addRoom(Scene& scene, std::uint32_t left = 0, std::uint32_t right = 0) {
  const std::uint32_t first = addCorners(scene, {Vec3(0), Vec3(4), 0});
  for (const Face& face : {kBack, kFloor, kCeiling}) addFace(scene, first, face);
  addFace(scene, first, kLeft, left);
  addFace(scene, first, kRight, right);
  return first;
}

void addLight(Scene& scene) {
  const auto first = static_cast<std::uint32_t>(scene.positions.size());
  for (int corner = 0; corner < 4; ++corner)
    scene.positions.emplace_back(corner & 1 ? kLightHalfSide : -kLightHalfSide, kLightHeight,
                                 corner & 2 ? kLightHalfSide : -kLightHalfSide);
  addFace(scene, first, {0, 1, 3, 2}, kLightMaterial);
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

Scene makeBenchBox() {
  Scene scene;
  scene.name = "box";
  scene.materials.resize(4);
  scene.materials[kLightMaterial].emission = Vec3(10);
  scene.materials[kRed].base_color = {0.6f, 0.06f, 0.05f};
  scene.materials[kGreen].base_color = {0.12f, 0.45f, 0.1f};
  scene.camera.position = {0, 0, 3.9f};
  scene.camera.target = {0, 0, 0};
  scene.camera.up = {0, 1, 0};
  scene.camera.vertical_fov = 75;
  addFace(scene, addRoom(scene, kRed, kGreen), kFront);
  addBlock(scene, {{-1.4f, -1.6f, -1.5f}, {1.2f, 2.4f, 1.2f}, 0.3f});
  addBlock(scene, {{1.5f, -2.8f, 0.6f}, {1.2f, 1.2f, 1.2f}, -0.3f});
  addLight(scene);
  return scene;
}

}  // namespace glimt
