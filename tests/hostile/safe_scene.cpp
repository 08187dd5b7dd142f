#include "tests/hostile/safe_scene.h"

#include <algorithm>
#include <cmath>

#include "renderer/scene/effects_of.h"

namespace glimt {
namespace {

bool isFinite(const Vec3& v) {
  return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

bool isUnit(const Vec3& v) {
  return std::abs(glm::length(v) - 1) < 1e-5f;
}

bool indicesInRange(const Scene& scene, const Triangle& triangle) {
  const auto hasPosition = [&](std::uint32_t i) { return i < scene.positions.size(); };
  const auto hasNormal = [&](std::uint32_t i) {
    return triangle.smooth() ? i < scene.normals.size() : i == kNoIndex;
  };
  return triangle.material < scene.materials.size() &&
         std::all_of(triangle.positions.begin(), triangle.positions.end(), hasPosition) &&
         std::all_of(triangle.normals.begin(), triangle.normals.end(), hasNormal);
}

bool isSound(const Material& material) {
  for (int c = 0; c < 3; ++c) {
    if (!(material.base_color[c] >= 0 && material.base_color[c] <= 1)) return false;
    if (!(material.emission[c] >= 0)) return false;
  }
  return isFinite(material.emission);
}

}  // namespace

std::string flawOf(const Scene& scene) {
  for (const Triangle& triangle : scene.triangles) {
    if (!indicesInRange(scene, triangle)) return "a triangle's index is out of range";
  }
  if (!std::all_of(scene.positions.begin(), scene.positions.end(), isFinite)) {
    return "a position is not finite";
  }
  if (!std::all_of(scene.normals.begin(), scene.normals.end(), isUnit)) {
    return "a normal has not unit length";
  }
  if (!std::all_of(scene.materials.begin(), scene.materials.end(), isSound)) {
    return "a material reflects or emits what cannot be";
  }
  const Camera& camera = scene.camera;
  if (!isFinite(camera.position) || !isFinite(camera.target)) return "the camera is not finite";
  if (camera.position == camera.target) return "the camera is where it looks";
  if (!effectsOf(scene).any()) return "no effect is on";
  for (const std::string& warning : scene.warnings) {
    if (warning.find('\n') != std::string::npos) return "a warning is not one line";
  }
  return {};
}

}  // namespace glimt
