#include "renderer/bvh/bvh.h"

#include <algorithm>
#include <catch2/catch.hpp>
#include <limits>
#include <random>
#include <thread>

#include "renderer/bvh/parallel_for.h"
#include "renderer/bvh/reinsertion.h"

using namespace glimt;

namespace {

bool contains(const Bounds& outer, const Bounds& inner) {
  return glm::all(glm::lessThanEqual(outer.min, inner.min)) &&
         glm::all(glm::greaterThanEqual(outer.max, inner.max));
}

// Small boxes in a cube, and a few that are as large as the cube.
std::vector<Bounds> scattered(std::size_t count, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<float> place(-10, 10);
  std::uniform_real_distribution<float> size(0, 0.2f);
  std::vector<Bounds> boxes(count);
  for (std::size_t i = 0; i < count; ++i) {
    const Vec3 corner(place(random), place(random), place(random));
    boxes[i].include(corner);
    boxes[i].include(i % 1000 == 0 ? -corner
                                   : corner + Vec3(size(random), size(random), size(random)));
  }
  return boxes;
}

std::vector<Bounds> points(const std::vector<Vec3>& places) {
  std::vector<Bounds> boxes;
  for (const Vec3& place : places) boxes.push_back({place, place});
  return boxes;
}

// How often each primitive is in a leaf.
std::vector<int> timesInLeaves(const Bvh& bvh) {
  std::vector<int> times(bvh.order.size(), 0);
  for (const BvhNode& node : bvh.nodes)
    for (std::uint32_t i = node.first; i < node.first + node.count; ++i) ++times[bvh.order.at(i)];
  return times;
}

// How often each node is a child.
std::vector<int> timesChild(const Bvh& bvh) {
  std::vector<int> times(bvh.nodes.size(), 0);
  for (const BvhNode& node : bvh.nodes) {
    if (node.leaf()) continue;
    ++times.at(node.first);
    ++times.at(node.first + 1);
  }
  return times;
}

bool holdsAllBelow(const Bvh& bvh, const BvhNode& node, const std::vector<Bounds>& boxes) {
  if (!node.leaf())
    return contains(node.bounds, bvh.nodes.at(node.first).bounds) &&
           contains(node.bounds, bvh.nodes.at(node.first + 1).bounds);
  return std::all_of(bvh.order.begin() + node.first, bvh.order.begin() + node.first + node.count,
                     [&](std::uint32_t i) { return contains(node.bounds, boxes[i]); });
}

int depthOf(const Bvh& bvh) {
  std::vector<int> depth(bvh.nodes.size(), 1);
  for (std::size_t i = 0; i < bvh.nodes.size(); ++i)
    if (!bvh.nodes[i].leaf())
      depth[bvh.nodes[i].first] = depth[bvh.nodes[i].first + 1] = depth[i] + 1;
  return *std::max_element(depth.begin(), depth.end());
}

void checkTree(const Bvh& bvh, const std::vector<Bounds>& boxes) {
  REQUIRE(bvh.order.size() == boxes.size());
  CHECK(timesInLeaves(bvh) == std::vector<int>(boxes.size(), 1));
  std::vector<int> once(bvh.nodes.size(), 1);
  once.front() = 0;
  CHECK(timesChild(bvh) == once);
  for (std::size_t i = 0; i < bvh.nodes.size(); ++i) {
    const BvhNode& node = bvh.nodes[i];
    if (node.count > kMaxLeafSize || (!node.leaf() && node.first <= i) || node.axis > 2)
      FAIL_CHECK("node " << i << ": " << node.count << " from " << node.first);
    if (!holdsAllBelow(bvh, node, boxes)) FAIL_CHECK("node " << i << " is too small");
  }
}

double costOf(const std::vector<BvhNode>& nodes) {
  double cost = 0;
  for (const BvhNode& node : nodes)
    if (!node.leaf()) cost += static_cast<double>(node.bounds.halfArea());
  return cost;
}

// One primitive a leaf, in halves that have nothing to do with where they are.
Bvh careless(const std::vector<Bounds>& boxes) {
  Bvh bvh;
  const std::size_t inner = boxes.size() - 1;
  bvh.nodes.resize(2 * boxes.size() - 1);
  for (std::uint32_t i = 0; i < boxes.size(); ++i) {
    bvh.order.push_back(i);
    bvh.nodes[inner + i] = {boxes[i], i, 1, 0};
  }
  for (std::uint32_t i = static_cast<std::uint32_t>(inner); i-- > 0;) {
    bvh.nodes[i] = {bvh.nodes[2 * i + 1].bounds, 2 * i + 1, 0, 0};
    bvh.nodes[i].bounds.include(bvh.nodes[2 * i + 2].bounds);
  }
  return bvh;
}

bool same(const BvhNode& a, const BvhNode& b) {
  return a.bounds.min == b.bounds.min && a.bounds.max == b.bounds.max && a.first == b.first &&
         a.count == b.count && a.axis == b.axis;
}

}  // namespace

TEST_CASE("A tree holds each primitive once, in boxes that contain it") {
  for (const std::size_t count : {2u, 3u, 5u, 16u, 17u, 100u, 5000u, 60000u, 210000u}) {
    CAPTURE(count);
    const std::vector<Bounds> boxes = scattered(count, 7);
    checkTree(buildBvh(boxes), boxes);
  }
}

TEST_CASE("A tree is the same whatever the number of threads") {
  const std::vector<Bounds> boxes = scattered(150000, 3);
  const Bvh one = buildBvh(boxes, 1);
  checkTree(one, boxes);
  for (const unsigned threads : {0u, 2u, 3u}) {
    CAPTURE(threads);
    const Bvh other = buildBvh(boxes, threads);
    CHECK(other.order == one.order);
    CHECK(std::equal(one.nodes.begin(), one.nodes.end(), other.nodes.begin(), other.nodes.end(),
                     same));
  }
}

TEST_CASE("The lower child comes first along the node's axis") {
  const std::vector<Bounds> boxes = points({{0, 5, 0}, {0, 1, 0}, {0, 2, 0}, {0, 4, 0}, {1, 3, 0}});
  const Bvh bvh = buildBvh(boxes);
  for (const BvhNode& node : bvh.nodes) {
    if (node.leaf()) continue;
    const Bounds& lower = bvh.nodes[node.first].bounds;
    const Bounds& upper = bvh.nodes[node.first + 1].bounds;
    CHECK(lower.center()[node.axis] <= upper.center()[node.axis]);
  }
}

TEST_CASE("Clusters far apart are divided first") {
  std::vector<Bounds> boxes = scattered(1000, 5);
  for (std::size_t i = 0; i < boxes.size(); ++i)
    if (i % 3 == 0) boxes[i] = {boxes[i].min + Vec3(0, 0, 500), boxes[i].max + Vec3(0, 0, 500)};
  const Bvh bvh = buildBvh(boxes);
  CHECK(bvh.nodes[0].axis == 2);
  CHECK(bvh.nodes[bvh.nodes[0].first].bounds.max.z < 100);
  CHECK(bvh.nodes[bvh.nodes[0].first + 1].bounds.min.z > 400);
}

TEST_CASE("No primitives make no nodes") {
  const Bvh bvh = buildBvh({});
  CHECK(bvh.nodes.empty());
  CHECK(bvh.order.empty());
}

TEST_CASE("One primitive makes one leaf") {
  const std::vector<Bounds> boxes = scattered(1, 1);
  const Bvh bvh = buildBvh(boxes);
  REQUIRE(bvh.nodes.size() == 1);
  CHECK(bvh.nodes[0].count == 1);
  checkTree(bvh, boxes);
}

TEST_CASE("Equal boxes make a balanced tree") {
  const Bounds box{Vec3(1, 2, 3), Vec3(2, 3, 4)};
  const std::vector<Bounds> boxes(50000, box);
  const Bvh bvh = buildBvh(boxes);
  checkTree(bvh, boxes);
  CHECK(depthOf(bvh) <= 17);
}

TEST_CASE("Boxes of different sizes around one point make a shallow tree") {
  std::vector<Bounds> boxes;
  for (int i = 1; i <= 20000; ++i)
    boxes.push_back({Vec3(static_cast<float>(-i)), Vec3(static_cast<float>(i))});
  const Bvh bvh = buildBvh(boxes);
  checkTree(bvh, boxes);
  CHECK(depthOf(bvh) <= 17);
}

TEST_CASE("Points on a line make a shallow tree although no box has an area") {
  std::vector<Vec3> places;
  for (int i = 0; i < 30000; ++i) places.emplace_back(i, 0, 0);
  const std::vector<Bounds> boxes = points(places);
  const Bvh bvh = buildBvh(boxes);
  checkTree(bvh, boxes);
  CHECK(depthOf(bvh) <= 20);
}

TEST_CASE("Centroids closer than a float's smallest normal number make a tree") {
  const float tiny = std::numeric_limits<float>::denorm_min();
  std::vector<Vec3> places;
  for (int i = 0; i < 1000; ++i) places.emplace_back(static_cast<float>(i % 7) * tiny, 0, 0);
  const std::vector<Bounds> boxes = points(places);
  checkTree(buildBvh(boxes), boxes);
}

TEST_CASE("Boxes at the ends of the range of floats make a tree") {
  const float huge = std::numeric_limits<float>::max();
  std::vector<Vec3> places;
  for (int i = 0; i < 1000; ++i)
    places.emplace_back(i % 2 == 0 ? huge : -huge, i % 3 == 0 ? huge : -huge, i % 5);
  const std::vector<Bounds> boxes = points(places);
  checkTree(buildBvh(boxes), boxes);
}

TEST_CASE("Reinsertion makes a careless tree cheaper, and it stays a tree") {
  const std::vector<Bounds> boxes = scattered(3000, 11);
  Bvh bvh = careless(boxes);
  const double before = costOf(bvh.nodes);
  reinsertNodes(bvh.nodes);
  checkTree(bvh, boxes);
  CHECK(costOf(bvh.nodes) < 0.95 * before);
}

TEST_CASE("Progress of building never goes down, and ends at 1") {
  // The larger one is built without reinsertion.
  for (const std::size_t count : {0u, 1u, 100000u, 210000u}) {
    CAPTURE(count);
    std::vector<float> told;
    const auto caller = std::this_thread::get_id();
    buildBvh(scattered(count, 9), 2, [&](float fraction) {
      CHECK(std::this_thread::get_id() == caller);
      told.push_back(fraction);
    });
    REQUIRE(!told.empty());
    CHECK(told.front() >= 0);
    CHECK(std::is_sorted(told.begin(), told.end()));
    CHECK(told.back() == 1);
    if (count >= 100000) CHECK(told.size() >= 5);
  }
}

TEST_CASE("What progress throws ends building") {
  for (const float end : {0.0f, 0.2f, 0.5f})
    CHECK_THROWS_AS(buildBvh(scattered(100000, 9), 2,
                             [&](float fraction) {
                               if (fraction >= end) throw std::bad_alloc();
                             }),
                    std::bad_alloc);
}

TEST_CASE("A parallel loop calls its body once for each index") {
  for (const unsigned threads : {1u, 2u, 5u}) {
    std::vector<int> calls(1000, 0);
    parallelFor(threads, calls.size(), [&](std::size_t i) { ++calls[i]; });
    CHECK(calls == std::vector<int>(1000, 1));
  }
  parallelFor(2, 0, [](std::size_t) { FAIL("there is no index"); });
}

TEST_CASE("A parallel loop throws what its body throws") {
  for (const unsigned threads : {1u, 3u})
    CHECK_THROWS_AS(parallelFor(threads, 100,
                                [](std::size_t i) {
                                  if (i == 50) throw std::bad_alloc();
                                }),
                    std::bad_alloc);
}
