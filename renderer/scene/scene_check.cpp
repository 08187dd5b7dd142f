#include "renderer/scene/scene_check.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "renderer/core/wording.h"
#include "renderer/scene/light_check.h"
#include "renderer/scene/texture_uses.h"

namespace glimt {
namespace {

enum class Flaw { none, bad_index, not_finite, too_far, no_area };

Flaw flawOf(const Vec3& v) {
  if (!std::isfinite(v.x) || !std::isfinite(v.y) || !std::isfinite(v.z)) return Flaw::not_finite;
  const Vec3 size = glm::abs(v);
  return std::max({size.x, size.y, size.z}) > kLargestCoordinate ? Flaw::too_far : Flaw::none;
}

// As the renderer computes it: in floats, where very thin and very small triangles vanish.
bool hasArea(const Vec3& a, const Vec3& b, const Vec3& c) {
  const Vec3 normal = glm::cross(b - a, c - a);
  return glm::dot(normal, normal) >= std::numeric_limits<float>::min();
}

Flaw flawOf(const Triangle& triangle, const Scene& scene) {
  if (triangle.material >= scene.materials.size()) return Flaw::bad_index;
  for (const std::uint32_t index : triangle.positions) {
    if (index >= scene.positions.size()) return Flaw::bad_index;
  }
  for (const std::uint32_t index : triangle.positions) {
    const Flaw flaw = flawOf(scene.positions[index]);
    if (flaw != Flaw::none) return flaw;
  }
  const auto& [a, b, c] = triangle.positions;
  const bool has_area = hasArea(scene.positions[a], scene.positions[b], scene.positions[c]);
  return has_area ? Flaw::none : Flaw::no_area;
}

void dropFlawedTriangles(Scene& scene) {
  std::array<std::size_t, 5> counts{};
  const std::size_t before = scene.triangles.size();
  std::erase_if(scene.triangles, [&](const Triangle& triangle) {
    const Flaw flaw = flawOf(triangle, scene);
    ++counts[static_cast<std::size_t>(flaw)];
    return flaw != Flaw::none;
  });
  const auto warn = [&](Flaw flaw, const char* why) {
    const std::size_t count = counts[static_cast<std::size_t>(flaw)];
    if (count == 0) return;
    scene.warnings.push_back(fmt::format("dropped {} {}", counted(count, "triangle"), why));
  };
  warn(Flaw::bad_index, "with an index out of range");
  warn(Flaw::not_finite, "with a vertex that is not a finite number");
  warn(Flaw::too_far, "with a vertex farther than 100,000 km from the origin");
  warn(Flaw::no_area, "without an area");
  if (before > 0 && scene.triangles.empty()) {
    scene.warnings.push_back("no triangle is left; the picture shows the environment alone");
  }
}

// False when there is no direction in it.
bool normalise(Vec3& normal) {
  const glm::dvec3 n(normal);
  const double length = std::sqrt(glm::dot(n, n));
  if (!(length > 0) || !std::isfinite(length)) return false;
  normal = Vec3(n / length);
  return true;
}

void checkNormals(Scene& scene) {
  std::vector<bool> usable(scene.normals.size());
  for (std::size_t i = 0; i < usable.size(); ++i) usable[i] = normalise(scene.normals[i]);
  std::size_t made_flat = 0;
  for (Triangle& triangle : scene.triangles) {
    const auto given = [](std::uint32_t index) { return index != kNoIndex; };
    const auto good = [&](std::uint32_t index) { return index < usable.size() && usable[index]; };
    const auto& normals = triangle.normals;
    if (std::all_of(normals.begin(), normals.end(), good)) continue;
    if (std::any_of(normals.begin(), normals.end(), given)) ++made_flat;
    triangle.normals.fill(kNoIndex);
  }
  if (made_flat > 0) {
    scene.warnings.push_back(fmt::format("shaded {} flat: a normal is missing, zero or not finite",
                                         counted(made_flat, "triangle")));
  }
}

// Keeps the used ones in their order; returns the new index of each old one.
std::vector<std::uint32_t> keepUsed(std::vector<Vec3>& values, const std::vector<bool>& used) {
  std::vector<std::uint32_t> moved_to(values.size(), kNoIndex);
  std::uint32_t count = 0;
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (!used[i]) continue;
    moved_to[i] = count;
    values[count++] = values[i];
  }
  values.resize(count);
  return moved_to;
}

void removeUnused(Scene& scene) {
  std::vector<bool> used_position(scene.positions.size());
  std::vector<bool> used_normal(scene.normals.size());
  for (const Triangle& triangle : scene.triangles) {
    for (const std::uint32_t i : triangle.positions) used_position[i] = true;
    if (!triangle.smooth()) continue;
    for (const std::uint32_t i : triangle.normals) used_normal[i] = true;
  }
  const std::vector<std::uint32_t> position = keepUsed(scene.positions, used_position);
  const std::vector<std::uint32_t> normal = keepUsed(scene.normals, used_normal);
  for (Triangle& triangle : scene.triangles) {
    for (std::uint32_t& i : triangle.positions) i = position[i];
    if (!triangle.smooth()) continue;
    for (std::uint32_t& i : triangle.normals) i = normal[i];
  }
}

// Brings each channel into [low, high]; what is not a number becomes `low`. True when it changed.
bool clampChannels(Vec3& color, float low, float high) {
  const Vec3 before = color;
  for (int c = 0; c < 3; ++c) {
    if (!(color[c] >= low)) color[c] = low;
    if (color[c] > high) color[c] = high;
  }
  return color != before;
}

// True when it changed.
bool clampNumber(float& value, float low, float high) {
  const float before = value;
  if (!(value >= low)) value = low;
  if (value > high) value = high;
  return value != before;
}

// A rough boundary that bends nothing has no facets to be seen by: it is as invisible as a smooth
// one.
bool clampSurface(Material& material) {
  constexpr float kMostIor = 1000;
  constexpr float kBendsNothing = 1e-4f;
  bool changed = false;
  for (float* share :
       {&material.metallic, &material.roughness, &material.specular, &material.transmission,
        &material.clearcoat, &material.clearcoat_roughness, &material.sheen_roughness})
    changed |= clampNumber(*share, 0, 1);
  changed |= clampChannels(material.sheen_color, 0, 1);
  changed |= clampChannels(material.attenuation_color, 0, 1);
  changed |= clampNumber(material.attenuation_distance, 0, std::numeric_limits<float>::max());
  changed |= clampNumber(material.ior, 1, kMostIor);
  const bool bends = material.ior >= 1 + kBendsNothing || material.thin_walled;
  if (material.transmission > 0 && !bends) material.roughness = 0;
  return changed;
}

void checkMaterials(Scene& scene) {
  std::vector<std::string> recolored;
  std::vector<std::string> changed;
  std::vector<std::string> dimmed;
  for (Material& material : scene.materials) {
    if (clampChannels(material.base_color, 0, 1)) recolored.push_back(material.name);
    if (clampSurface(material)) changed.push_back(material.name);
    for (int c = 0; c < 3; ++c) {
      if (std::isinf(material.emission[c])) material.emission[c] = std::nanf("");
    }
    if (clampChannels(material.emission, 0, std::numeric_limits<float>::max())) {
      dimmed.push_back(material.name);
    }
  }
  if (!recolored.empty()) {
    scene.warnings.push_back(fmt::format(
        "base colour brought into 0 to 1: {} would reflect more light than there is, or less than "
        "none",
        listed(recolored)));
  }
  if (!changed.empty()) {
    scene.warnings.push_back(
        fmt::format("metallic, roughness, specular, transmission, clear coat, sheen or attenuation "
                    "brought into 0 to 1, or the index of refraction to 1 or more: {}",
                    listed(changed)));
  }
  if (!dimmed.empty()) {
    scene.warnings.push_back(
        fmt::format("emission that is negative or not finite became 0: {}", listed(dimmed)));
  }
}

}  // namespace

void checkScene(Scene& scene) {
  dropFlawedTriangles(scene);
  checkNormals(scene);
  removeUnused(scene);
  checkMaterials(scene);
  checkLights(scene);
  checkTextures(scene);
}

}  // namespace glimt
