#include "tests/gpu/test_scene.h"

#include <cmath>
#include <filesystem>
#include <numbers>

#include "renderer/scene/load_scene.h"
#include "tests/shader/report.h"

namespace glimt::test {
namespace {

constexpr int kRings = 1000;
constexpr int kSides = 35;

// The (2, 3) torus knot.
glm::dvec3 knotCurve(double s) {
  const double r = 2 + std::cos(3 * s);
  return {r * std::cos(2 * s), r * std::sin(2 * s), std::sin(3 * s)};
}

Vec3 tubePoint(int ring, int side) {
  const double s = 2 * std::numbers::pi * ring / kRings;
  const double angle = 2 * std::numbers::pi * side / kSides;
  const glm::dvec3 center = knotCurve(s);
  const glm::dvec3 along = glm::normalize(knotCurve(s + 1e-4) - knotCurve(s - 1e-4));
  const glm::dvec3 across = glm::normalize(glm::cross(along, center));
  const glm::dvec3 up = glm::cross(across, along);
  const double radius = 0.35 + 0.08 * std::sin(20 * s + 3 * angle);
  return Vec3(center + radius * (std::cos(angle) * across + std::sin(angle) * up));
}

void addQuad(Scene& scene, std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t d) {
  Triangle triangle;
  triangle.positions = {a, b, c};
  scene.triangles.push_back(triangle);
  triangle.positions = {a, c, d};
  scene.triangles.push_back(triangle);
}

void addKnot(Scene& scene) {
  const auto index = [](int ring, int side) {
    return static_cast<std::uint32_t>(ring % kRings * kSides + side % kSides);
  };
  for (int ring = 0; ring < kRings; ++ring) {
    for (int side = 0; side < kSides; ++side) {
      scene.positions.push_back(tubePoint(ring, side));
      addQuad(scene, index(ring, side), index(ring + 1, side), index(ring + 1, side + 1),
              index(ring, side + 1));
    }
  }
}

void addBox(Scene& scene, const Bounds& box) {
  const auto first = static_cast<std::uint32_t>(scene.positions.size());
  for (int corner = 0; corner < 8; ++corner)
    scene.positions.emplace_back(corner & 1 ? box.max.x : box.min.x,
                                 corner & 2 ? box.max.y : box.min.y,
                                 corner & 4 ? box.max.z : box.min.z);
  const auto side = [&](std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t d) {
    addQuad(scene, first + a, first + b, first + c, first + d);
  };
  side(0, 1, 3, 2);
  side(4, 5, 7, 6);
  side(0, 1, 5, 4);
  side(2, 3, 7, 6);
  side(0, 2, 6, 4);
  side(1, 3, 7, 5);
}

void numberTriangles(Scene& scene) {
  scene.materials.resize(scene.triangles.size());
  for (std::uint32_t i = 0; i < scene.triangles.size(); ++i) scene.triangles[i].material = i;
}

}  // namespace

Scene knotInBox() {
  Scene scene;
  addKnot(scene);
  addBox(scene, {Vec3(-3.7f, -3.6f, -1.7f), Vec3(3.7f, 3.5f, 1.8f)});
  numberTriangles(scene);
  return scene;
}

std::optional<Scene> referenceKnot() {
  const std::filesystem::path path =
      std::filesystem::path(GLIMT_SHARED_DIR) / "reference" / "knot.obj";
  if (!std::filesystem::exists(path)) {
    report("skipped: {} is not there", path.string());
    return std::nullopt;
  }
  Scene scene = loadScene(path);
  numberTriangles(scene);
  return scene;
}

Bounds boundsOf(const Scene& scene) {
  Bounds bounds;
  for (const Vec3& position : scene.positions) bounds.include(position);
  return bounds;
}

}  // namespace glimt::test
