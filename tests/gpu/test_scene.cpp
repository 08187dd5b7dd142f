#include "tests/gpu/test_scene.h"

#include <filesystem>

#include "renderer/bench/knot.h"
#include "renderer/scene/load_scene.h"
#include "tests/shader/report.h"

namespace glimt::test {
namespace {

void addBox(Scene& scene, const Bounds& box) {
  const auto first = static_cast<std::uint32_t>(scene.positions.size());
  for (int corner = 0; corner < 8; ++corner)
    scene.positions.emplace_back(corner & 1 ? box.max.x : box.min.x,
                                 corner & 2 ? box.max.y : box.min.y,
                                 corner & 4 ? box.max.z : box.min.z);
  const auto side = [&](std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t d) {
    addQuad(scene, {first + a, first + b, first + c, first + d});
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
  addKnot(scene, {1000, 35});
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
