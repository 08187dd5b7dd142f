// What is to be rendered, as plain values: the common ground of all file formats.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "renderer/core/image.h"
#include "renderer/core/vector.h"
#include "renderer/scene/camera.h"

namespace glimt {

struct Material {
  std::string name;
  Vec3 base_color{0.8f};     // reflectance, linear, each channel in [0, 1]
  Vec3 emission{0};          // radiance, linear, >= 0
  bool double_sided = true;  // false: emits on the front side only (counter-clockwise winding)
  // In glTF's terms. As they stand here: a Lambert surface.
  float metallic = 0;      // in [0, 1]
  float roughness = 1;     // in [0, 1]; its square is GGX's alpha; 0 is an exact mirror
  float specular = 0;      // strength of a dielectric's reflection, in [0, 1]
  float ior = 1.5f;        // index of refraction, >= 1; 1 is invisible
  float transmission = 0;  // share of what enters a dielectric that goes through, in [0, 1]
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
  Vec3 color{0};  // radiance, linear; with a picture, what its radiance is multiplied by
  float strength = 1;
  Image image;         // of all directions, equirectangular: its top up, +x in its centre; or none
  float rotation = 0;  // of the picture about +y, in degrees, counter-clockwise seen from above

  // Of an even environment, without a picture.
  Vec3 radiance() const { return color * strength; }
  // Whether any light comes from it.
  bool shines() const;
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
