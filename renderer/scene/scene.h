// What is to be rendered, as plain values: the common ground of all file formats.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "renderer/core/vector.h"
#include "renderer/scene/camera.h"

namespace glimt {

struct Material {
  std::string name;
  Vec3 base_color{0.8f};     // reflectance of the Lambert surface, linear, each channel in [0, 1]
  Vec3 emission{0};          // radiance, linear, >= 0
  bool double_sided = true;  // false: emits on the front side only (counter-clockwise winding)
};

inline constexpr std::uint32_t kNoIndex = 0xffffffffu;

struct Triangle {
  std::array<std::uint32_t, 3> positions{};                            // into Scene::positions
  std::array<std::uint32_t, 3> normals{kNoIndex, kNoIndex, kNoIndex};  // into Scene::normals
  std::uint32_t material = 0;                                          // into Scene::materials

  bool smooth() const { return normals[0] != kNoIndex; }
};

// Light that arrives from infinitely far away.
struct Environment {
  Vec3 color{0};  // radiance, linear
  float strength = 1;

  Vec3 radiance() const { return color * strength; }
};

// What the scene's file asks for; the command line wins over it.
struct RenderDefaults {
  std::optional<std::array<int, 2>> size;  // width, height in pixels
  std::optional<int> bounces;              // secondary bounces
  std::optional<float> exposure;           // EV
};

struct Scene {
  std::string name;
  // Where the scene's coordinates begin, in those of its file: a model far from the file's origin
  // is moved there, so that floats resolve it. Positions and the camera are relative to it.
  glm::dvec3 origin{0};
  std::vector<Vec3> positions;  // world space, metres, finite
  std::vector<Vec3> normals;    // unit length
  std::vector<Triangle> triangles;
  std::vector<Material> materials;
  Camera camera;
  Environment environment;
  RenderDefaults render;
  std::vector<std::string> warnings;  // one line each, for people
};

}  // namespace glimt
