// What the bench tells of the device: counts that follow from the layout of a tree, and rates.
#include <catch2/catch.hpp>
#include <cmath>

#include "renderer/bench/device_ceilings.h"
#include "renderer/bench/ray_work.h"
#include "tests/gpu/contexts.h"

using namespace glimt;

namespace {

using Question = TraversalProgram::Question;

constexpr float kApart = 10;  // metres, between squares

// Two triangles at z = 0.
void addSquare(Scene& scene, float x) {
  const auto first = static_cast<std::uint32_t>(scene.positions.size());
  for (const Vec2 corner : {Vec2(-1, -1), Vec2(1, -1), Vec2(1, 1), Vec2(-1, 1)})
    scene.positions.emplace_back(corner + Vec2(x, 0), 0.0f);
  for (const std::uint32_t third : {2u, 3u}) {
    Triangle triangle;
    triangle.positions = {first, first + third - 1, first + third};
    scene.triangles.push_back(triangle);
  }
}

// Squares of two triangles, so far apart that each of two is a leaf.
Scene squares(int count) {
  Scene scene;
  scene.materials.resize(1);
  for (int i = 0; i < count; ++i) addSquare(scene, kApart * static_cast<float>(i));
  return scene;
}

// Through the upper left of the square at the origin, where its second triangle is; beside all
// boxes; and one that is not live.
Rays threeRays() {
  Rays rays;
  rays.origins = {Vec4(-0.5f, 0.5f, 5, 0), Vec4(-0.5f, 5, 5, 0), Vec4(0), Vec4(0)};
  rays.directions = {Vec4(0, 0, -10, 0), Vec4(0, 0, -10, 0), Vec4(0), Vec4(0)};
  return rays;
}

struct Expected {
  std::string traversal;
  std::array<RayWork, 3> rays;
};

void checkWork(const RayWork& counted, const RayWork& expected) {
  CHECK(counted.node_fetches == expected.node_fetches);
  CHECK(counted.triangle_fetches == expected.triangle_fetches);
  CHECK(counted.box_tests == expected.box_tests);
  CHECK(counted.triangle_tests == expected.triangle_tests);
}

void checkCounts(const gl::Device& device, const Scene& scene, Question question,
                 const Expected& expected) {
  const RayTextures rays(device, threeRays(), 2);
  const SceneTextures textures(device, scene, traversalNamed(expected.traversal).layout);
  const auto works = countRayWork(device, expected.traversal, question, textures, rays);
  for (std::size_t i = 0; i < expected.rays.size(); ++i) {
    CAPTURE(expected.traversal, i);
    checkWork(works[i], expected.rays[i]);
  }
}

void checkOnEveryContext(const Scene& scene, Question question, const std::vector<Expected>& all) {
  test::onEveryContext([&](const test::TestContext& context) {
    CAPTURE(context.name());
    for (const Expected& expected : all) checkCounts(context.device(), scene, question, expected);
  });
}

}  // namespace

TEST_CASE("work is counted as the layout of a tree of one leaf says") {
  // Depth first: the leaf, then the end. In pairs: the root and its neighbour, which is the end
  // with the same box. A triangle has three texels, and a leaf of two is read to its end.
  checkOnEveryContext(squares(1), Question::closest_hit,
                      {{"skip", {{{2, 6, 2, 2}, {2, 0, 2, 0}, {1, 0, 1, 0}}}},
                       {"octant", {{{2, 6, 2, 2}, {2, 0, 2, 0}, {1, 0, 1, 0}}}},
                       {"stack", {{{2, 6, 2, 2}, {2, 0, 2, 0}, {0, 0, 0, 0}}}}});
}

TEST_CASE("work is counted as the layout of a tree of two leaves says") {
  // Root, two leaves and the end, of which the second leaf is missed; a missed root leads to the
  // end. In pairs: the root's, then its children's.
  checkOnEveryContext(squares(2), Question::closest_hit,
                      {{"skip", {{{4, 6, 4, 2}, {2, 0, 2, 0}, {1, 0, 1, 0}}}},
                       {"octant", {{{4, 6, 4, 2}, {2, 0, 2, 0}, {1, 0, 1, 0}}}},
                       {"stack", {{{4, 6, 4, 2}, {2, 0, 2, 0}, {0, 0, 0, 0}}}}});
}

TEST_CASE("a ray that is blocked does no more work") {
  // By the second triangle of the only leaf: the end is not read.
  checkOnEveryContext(squares(1), Question::visibility,
                      {{"skip", {{{1, 6, 1, 2}, {2, 0, 2, 0}, {1, 0, 1, 0}}}}});
}

TEST_CASE("every rate of a device is finite and positive") {
  test::onEveryContext([](const test::TestContext& context) {
    DeviceBenchSettings settings;
    settings.sides = {32};
    settings.largest_texture = std::size_t{1} << 20;
    settings.repeats = 1;
    const auto rows = measureCeilings(context.device(), settings, [](const std::string&) {});
    CHECK(rows.size() == 10);  // arithmetic 4, independent fetches 4, chains 2
    for (const DeviceRow& row : rows) {
      CAPTURE(context.name(), row.work, row.note);
      REQUIRE(row.rate);
      CHECK(std::isfinite(row.rate->median));
      CHECK(row.rate->median > 0);
    }
  });
}
