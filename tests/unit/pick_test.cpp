#include "renderer/pick.h"

#include <catch2/catch.hpp>

#include "app/viewer/outline.h"

using namespace glimt;

namespace {

// Two squares that face +z: a small one of material 1 in front of a large one of material 0.
Scene squares() {
  Scene scene;
  scene.materials.resize(2);
  const auto add = [&](float half, float z, std::uint32_t material) {
    const auto first = static_cast<std::uint32_t>(scene.positions.size());
    for (const Vec2 corner : {Vec2(-1, -1), Vec2(1, -1), Vec2(1, 1), Vec2(-1, 1)})
      scene.positions.emplace_back(half * corner, z);
    for (const std::uint32_t second : {1u, 2u}) {
      Triangle triangle;
      triangle.positions = {first, first + second, first + second + 1};
      triangle.material = material;
      scene.triangles.push_back(triangle);
    }
  };
  add(4, 0, 0);
  add(1, 2, 1);
  return scene;
}

Camera fromFront() {
  Camera camera;
  camera.position = {0, 0, 10};
  camera.target = {0, 0, 0};
  camera.vertical_fov = 60;
  return camera;
}

std::optional<std::uint32_t> materialAt(const Scene& scene, const Camera& camera, Vec2 at) {
  const auto hit = pick(scene, Tree(scene), rayThrough(camera, at, 1));
  if (!hit) return {};
  return scene.triangles[hit->triangle].material;
}

}  // namespace

TEST_CASE("what is picked is what is nearest under the pointer") {
  const Scene scene = squares();
  CHECK(materialAt(scene, fromFront(), {0.51f, 0.52f}) == 1);
  CHECK(materialAt(scene, fromFront(), {0.7f, 0.5f}) == 0);
  CHECK(materialAt(scene, fromFront(), {0.01f, 0.5f}) == std::nullopt);
  // From behind the large one hides the small one.
  Camera behind = fromFront();
  behind.position.z = -10;
  CHECK(materialAt(scene, behind, {0.51f, 0.52f}) == 0);
}

TEST_CASE("the distance of a pick leads to the surface") {
  const Scene scene = squares();
  const Ray ray = rayThrough(fromFront(), {0.5f, 0.5f}, 1);
  const auto hit = pick(scene, Tree(scene), ray);
  REQUIRE(hit);
  CHECK((ray.origin + hit->distance * ray.direction).z == Approx(2));
}

TEST_CASE("a parallel projection is picked through its own rays") {
  Camera parallel = fromFront();
  parallel.orthographic_height = 10;
  const Scene scene = squares();
  CHECK(materialAt(scene, parallel, {0.59f, 0.5f}) == 1);
  CHECK(materialAt(scene, parallel, {0.61f, 0.5f}) == 0);
}

TEST_CASE("an outline goes round what shows the material, and nowhere else") {
  const Scene scene = squares();
  const LoadedScene loaded{SceneChoice(), scene, Tree(scene), 0, std::filesystem::file_time_type()};
  const Outline outline = outlineOf(loaded, fromFront(), 1, 64, 64, [](float) {});
  const auto marked = [&](int x, int y) {
    return outline.rgba[4 * static_cast<std::size_t>(64 * y + x) + 3] > 0;
  };
  // The small square covers half its size over what is seen at its depth: 2 of 9.24.
  const int edge = 32 + static_cast<int>(32 * 1 / 4.62f) - 1;
  CHECK((marked(edge, 32) || marked(edge - 1, 32) || marked(edge + 1, 32)));
  CHECK_FALSE(marked(32, 32));
  CHECK_FALSE(marked(60, 32));
}
