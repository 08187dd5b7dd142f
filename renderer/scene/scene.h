// What is to be rendered, as plain values: the common ground of all file formats.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "renderer/core/image.h"
#include "renderer/core/tone.h"
#include "renderer/core/vector.h"
#include "renderer/scene/camera.h"

namespace glimt {

inline constexpr std::uint32_t kNoIndex = 0xffffffffu;

// A picture on surfaces: four bytes a pixel, red, green, blue, alpha; rows from the top. Which of
// its channels are sRGB-encoded depends on what a material takes it for.
struct TextureImage {
  std::string name;  // for messages
  int width = 0;
  int height = 0;
  std::vector<std::uint8_t> rgba;
};

// What is beyond the edges of a texture.
enum class Wrap { repeat, mirror, clamp };

// How a material looks up a picture.
struct TextureUse {
  std::uint32_t image = kNoIndex;  // into Scene::images; kNoIndex: none
  int texcoords = 0;               // which of TexCoords::sets
  Wrap wrap_u = Wrap::repeat;
  Wrap wrap_v = Wrap::repeat;
  bool nearest = false;  // else bilinear
  // Applied to a vertex's coordinates, v running down from the picture's top: first the scale, then
  // the rotation (radians, as KHR_texture_transform defines it), then the offset.
  Vec2 offset{0};
  Vec2 scale{1};
  float rotation = 0;

  bool used() const { return image != kNoIndex; }
  bool operator==(const TextureUse&) const = default;
};

enum class AlphaMode {
  opaque,
  mask,   // a hole where alpha is below Material::alpha_cutoff
  blend,  // alpha is the share of light that does not pass
};

struct Material {
  std::string name;
  Vec3 base_color{0.8f};     // reflectance, linear, each channel in [0, 1]
  Vec3 emission{0};          // radiance, linear, >= 0
  bool double_sided = true;  // false: emits on the front side only (counter-clockwise winding)
  // In glTF's terms. As they stand here: a Lambert surface.
  float metallic = 0;        // in [0, 1]
  float roughness = 1;       // in [0, 1]; its square is GGX's alpha; 0 is an exact mirror
  float specular = 0;        // strength of a dielectric's reflection, in [0, 1]
  float ior = 1.5f;          // index of refraction, >= 1; 1 is invisible
  float transmission = 0;    // share of what enters a dielectric that goes through, in [0, 1]
  bool thin_walled = false;  // what goes through is not bent, and there is no inside
  // What is left of white light after attenuation_distance metres inside; 0 metres: all of it.
  Vec3 attenuation_color{1};
  float attenuation_distance = 0;
  float clearcoat = 0;            // strength of a coat of IOR 1.5 over the rest, in [0, 1]
  float clearcoat_roughness = 0;  // in [0, 1]
  Vec3 sheen_color{0};            // reflectance of fibres over the rest, each channel in [0, 1]
  float sheen_roughness = 0;      // in [0, 1]
  // Where the background is transparent the camera sees the shadows on it alone.
  bool shadow_catcher = false;
  bool unlit = false;  // shows its base colour as it is: emits it, and reflects nothing
  AlphaMode alpha_mode = AlphaMode::opaque;
  float alpha = 1;  // multiplies the texture's
  float alpha_cutoff = 0.5f;
  // Each multiplies the number beside it. Colours are sRGB-encoded, the others linear.
  TextureUse base_color_texture;          // colour, and alpha
  TextureUse metallic_roughness_texture;  // green: roughness; blue: metallic
  TextureUse emission_texture;            // colour
  TextureUse normal_texture;              // in the frame of the texture coordinates, as glTF has it
  float normal_scale = 1;                 // of its x and y
  TextureUse transmission_texture;        // red
  TextureUse clearcoat_texture;           // red
  TextureUse clearcoat_roughness_texture;  // green
  TextureUse sheen_color_texture;          // colour
  TextureUse sheen_roughness_texture;      // alpha

  bool operator==(const Material&) const = default;
};

// Texture coordinates of a vertex, v running down from the picture's top.
struct TexCoords {
  std::array<Vec2, 2> sets{Vec2(0), Vec2(0)};
};

struct Triangle {
  std::array<std::uint32_t, 3> positions{};                              // into Scene::positions
  std::array<std::uint32_t, 3> normals{kNoIndex, kNoIndex, kNoIndex};    // into Scene::normals
  std::array<std::uint32_t, 3> texcoords{kNoIndex, kNoIndex, kNoIndex};  // into Scene::texcoords
  std::array<std::uint32_t, 3> colors{kNoIndex, kNoIndex, kNoIndex};     // into Scene::colors
  std::uint32_t material = 0;                                            // into Scene::materials

  bool smooth() const { return normals[0] != kNoIndex; }
  bool textured() const { return texcoords[0] != kNoIndex; }
  bool colored() const { return colors[0] != kNoIndex; }
};

// Light that arrives from infinitely far away.
struct Environment {
  Vec3 color{0};  // radiance, linear; with a picture, what its radiance is multiplied by
  float strength = 1;
  Image image;         // of all directions, equirectangular: its top up, +x in its centre; or none
  float rotation = 0;  // of the picture about +y, in degrees, counter-clockwise seen from above
  // At most so many cells of the sky are told apart where light is looked for; 0: as many as may
  // be.
  std::size_t most_cells = 0;

  // Of an even environment, without a picture.
  Vec3 radiance() const { return color * strength; }
  // Whether any light comes from it.
  bool shines() const;
};

// A light without triangles.
struct PunctualLight {
  enum class Kind { point, spot, directional };

  std::string name;
  Kind kind = Kind::point;
  Vec3 position{0};          // of point and spot
  Vec3 direction{0, 0, -1};  // in which spot and directional shine, unit
  Vec3 intensity{1};         // radiant intensity; of directional: irradiance of a surface it faces
  float range = 0;           // metres, beyond which it gives no light; 0: none
  float inner_cone = 0;  // radians, half of the angle within which a spot is as bright as it gets
  float outer_cone = 0.785398f;  // and beyond which it is dark
};

struct NamedCamera {
  std::string name;
  Camera camera;
};

// What the scene's file asks for; the command line wins over it.
struct RenderDefaults {
  std::optional<std::array<int, 2>> size;  // width, height in pixels
  std::optional<int> bounces;              // secondary bounces
  std::optional<float> exposure;           // EV
  std::optional<Tone> tone;
  std::optional<bool> transparent_background;
};

struct Scene {
  std::string name;
  // Where the scene's coordinates begin, in those of its file: a model far from the file's origin
  // is moved there, so that floats resolve it. Positions and the camera are relative to it.
  glm::dvec3 origin{0};
  std::vector<Vec3> positions;  // world space, metres, finite
  std::vector<Vec3> normals;    // unit length
  std::vector<Triangle> triangles;
  std::vector<TexCoords> texcoords;
  std::vector<Vec4> colors;  // linear, multiply the base colour and alpha
  std::vector<Material> materials;
  std::vector<TextureImage> images;
  std::vector<PunctualLight> lights;
  std::vector<NamedCamera> cameras;   // the file's own
  std::vector<std::string> variants;  // names of the materials' variants that the file has
  Camera camera;
  Environment environment;
  // The camera sees no light from outside the scene; other rays do.
  bool transparent_background = false;
  RenderDefaults render;
  std::vector<std::string> warnings;  // one line each, for people
};

}  // namespace glimt
