#include "renderer/pick.h"

#include <algorithm>
#include <limits>
#include <vector>

#include "renderer/passes/scene_tree.h"

namespace glimt {
namespace {

// Where the ray enters the box; infinity where it does not before `farthest`.
float entry(const Bounds& box, const Ray& ray, const Vec3& inverse, float farthest) {
  const Vec3 a = (box.min - ray.origin) * inverse;
  const Vec3 b = (box.max - ray.origin) * inverse;
  const Vec3 low = glm::min(a, b);
  const Vec3 high = glm::max(a, b);
  const float in = std::max({low.x, low.y, low.z, 0.0f});
  const float out = std::min({high.x, high.y, high.z, farthest});
  return in <= out ? in : std::numeric_limits<float>::infinity();
}

// Moeller and Trumbore 1997.
std::optional<float> distanceTo(const Scene& scene, const Triangle& triangle, const Ray& ray) {
  const Vec3& a = scene.positions[triangle.positions[0]];
  const Vec3 ab = scene.positions[triangle.positions[1]] - a;
  const Vec3 ac = scene.positions[triangle.positions[2]] - a;
  const Vec3 p = glm::cross(ray.direction, ac);
  const float determinant = glm::dot(ab, p);
  if (determinant == 0) return {};
  const Vec3 from = ray.origin - a;
  const float u = glm::dot(from, p) / determinant;
  const Vec3 q = glm::cross(from, ab);
  const float v = glm::dot(ray.direction, q) / determinant;
  const float distance = glm::dot(ac, q) / determinant;
  if (u >= 0 && v >= 0 && u + v <= 1 && distance > 0) return distance;
  return {};
}

}  // namespace

Ray rayThrough(const Camera& camera, Vec2 point, float aspect) {
  const CameraFrame frame(camera);
  const Vec2 at((2 * point.x - 1) * aspect, 1 - 2 * point.y);
  if (camera.orthographic_height > 0) {
    const Vec2 shift = 0.5f * camera.orthographic_height * at;
    return {camera.position + shift.x * frame.right + shift.y * frame.up, frame.forward};
  }
  const Vec2 slope = frame.half_height * at;
  return {camera.position,
          glm::normalize(frame.forward + slope.x * frame.right + slope.y * frame.up)};
}

std::optional<Pick> pick(const Scene& scene, const Tree& tree, const Ray& ray) {
  const Bvh& bvh = tree.get().bvh;
  if (bvh.nodes.empty()) return {};
  const Vec3 inverse = 1.0f / ray.direction;
  std::optional<Pick> nearest;
  float farthest = std::numeric_limits<float>::infinity();
  std::vector<std::uint32_t> stack{0};
  while (!stack.empty()) {
    const BvhNode& node = bvh.nodes[stack.back()];
    stack.pop_back();
    if (!(entry(node.bounds, ray, inverse, farthest) < farthest)) continue;
    if (!node.leaf()) {
      const bool upper_first = ray.direction[node.axis] < 0;
      stack.push_back(node.first + (upper_first ? 0u : 1u));
      stack.push_back(node.first + (upper_first ? 1u : 0u));
      continue;
    }
    for (std::uint32_t i = node.first; i < node.first + node.count; ++i) {
      const std::uint32_t triangle = bvh.order[i];
      const std::optional<float> distance = distanceTo(scene, scene.triangles[triangle], ray);
      if (!distance || *distance >= farthest) continue;
      farthest = *distance;
      nearest = Pick{triangle, farthest};
    }
  }
  return nearest;
}

}  // namespace glimt
