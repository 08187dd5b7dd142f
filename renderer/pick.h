// What is where in a picture, without GL.
#pragma once

#include <cstdint>
#include <optional>

#include "renderer/renderer.h"

namespace glimt {

struct Ray {
  Vec3 origin;
  Vec3 direction;
};

// Through the point of the camera's picture, (0, 0) being its top left and (1, 1) its bottom right;
// as through a pinhole, whatever the lens.
Ray rayThrough(const Camera& camera, Vec2 point, float aspect);

struct Pick {
  std::uint32_t triangle = 0;  // into Scene::triangles
  float distance = 0;          // in units of the ray's direction
};

// The first triangle that the ray meets, from either side; holes in a texture count as surface.
std::optional<Pick> pick(const Scene& scene, const Tree& tree, const Ray& ray);

}  // namespace glimt
