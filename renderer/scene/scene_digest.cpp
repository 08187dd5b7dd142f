#include "renderer/scene/scene_digest.h"

#include <type_traits>

#include "renderer/core/sha256.h"

namespace glimt {
namespace {

// Whose bytes are their values: no padding, no pointers.
template <typename T>
constexpr bool kPlain = std::is_arithmetic_v<T> || std::is_enum_v<T>;
template <>
constexpr bool kPlain<Vec2> = sizeof(Vec2) == 2 * sizeof(float);
template <>
constexpr bool kPlain<Vec3> = sizeof(Vec3) == 3 * sizeof(float);
template <>
constexpr bool kPlain<Vec4> = sizeof(Vec4) == 4 * sizeof(float);
template <>
constexpr bool kPlain<Triangle> = std::has_unique_object_representations_v<Triangle>;
template <>
constexpr bool kPlain<TexCoords> = sizeof(TexCoords) == 4 * sizeof(float);

// Structures are taken apart with all their members, so that one more does not compile before it
// is thought of here.
class Digest {
 public:
  std::string text() { return hash_.digest(); }

  template <typename T>
  requires kPlain<T>
  void add(const T& value) { hash_.add({reinterpret_cast<const char*>(&value), sizeof value}); }

  template <typename T>
  void add(const std::vector<T>& values) {
    add(values.size());
    if constexpr (kPlain<T>) {
      hash_.add({reinterpret_cast<const char*>(values.data()), values.size() * sizeof(T)});
    } else {
      for (const T& value : values) add(value);
    }
  }

  template <typename First, typename Second, typename... Rest>
  void add(const First& first, const Second& second, const Rest&... rest) {
    add(first);
    add(second);
    (add(rest), ...);
  }

  void add(const Image& image) { add(image.width, image.height, image.pixels); }

  void add(const TextureImage& texture) {
    const auto& [name, width, height, rgba] = texture;
    add(width, height, rgba);
  }

  void add(const TextureUse& use) {
    const auto& [image, texcoords, wrap_u, wrap_v, nearest, offset, scale, rotation] = use;
    add(image, texcoords, wrap_u, wrap_v, nearest, offset, scale, rotation);
  }

  void add(const Material& material) {
    const auto& [name, base_color, emission, double_sided, metallic, roughness, specular, ior,
                 transmission, thin_walled, attenuation_color, attenuation_distance, clearcoat,
                 clearcoat_roughness, sheen_color, sheen_roughness, shadow_catcher, unlit,
                 alpha_mode, alpha, alpha_cutoff, base_color_texture, metallic_roughness_texture,
                 emission_texture, normal_texture, normal_scale, transmission_texture,
                 clearcoat_texture, clearcoat_roughness_texture, sheen_color_texture,
                 sheen_roughness_texture] = material;
    add(base_color, emission, double_sided, metallic, roughness, specular, ior, transmission,
        thin_walled, attenuation_color, attenuation_distance, clearcoat, clearcoat_roughness,
        sheen_color, sheen_roughness, shadow_catcher, unlit, alpha_mode, alpha, alpha_cutoff);
    add(base_color_texture, metallic_roughness_texture, emission_texture, normal_texture,
        normal_scale, transmission_texture, clearcoat_texture, clearcoat_roughness_texture,
        sheen_color_texture, sheen_roughness_texture);
  }

  void add(const PunctualLight& light) {
    const auto& [name, kind, position, direction, intensity, range, inner_cone, outer_cone] = light;
    add(kind, position, direction, intensity, range, inner_cone, outer_cone);
  }

  void add(const Camera& camera) {
    const auto& [position, target, up, vertical_fov, orthographic_height, aperture_radius,
                 focus_distance, aperture_blades] = camera;
    add(position, target, up, vertical_fov, orthographic_height, aperture_radius, focus_distance,
        aperture_blades);
  }

  void add(const Environment& environment) {
    const auto& [color, strength, image, rotation, most_cells] = environment;
    add(color, strength, image, rotation, most_cells);
  }

  void add(const Scene& scene) {
    const auto& [name, origin, positions, normals, triangles, texcoords, colors, materials, images,
                 lights, cameras, variants, camera, environment, transparent_background, render,
                 warnings] = scene;
    add(positions, normals, triangles, texcoords, colors, materials, images, lights, camera,
        environment, transparent_background);
  }

 private:
  Sha256 hash_;
};

}  // namespace

std::string digestOf(const Scene& scene) {
  Digest digest;
  digest.add(scene);
  return digest.text();
}

}  // namespace glimt
