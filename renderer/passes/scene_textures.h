// A scene and its tree as textures.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "renderer/gl/device.h"
#include "renderer/gl/program.h"
#include "renderer/passes/environment_map.h"
#include "renderer/passes/gloss_table.h"
#include "renderer/passes/light_shares.h"
#include "renderer/passes/scene_tree.h"
#include "renderer/passes/texture_atlas.h"
#include "renderer/scene/effects_of.h"
#include "renderer/scene/scene.h"

namespace glimt {

class SceneTextures {
 public:
  // Errors: input, when the scene is larger than the device's textures or the hit record can hold,
  // or its tree deeper than the traversal's stack. `change` as in PathTracerSettings.
  SceneTextures(const gl::Device& device, const Scene& scene, const SceneTree& tree,
                TreeLayout layout, const EffectChange& change = {});
  SceneTextures(const gl::Device& device, const Scene& scene, TreeLayout layout,
                const WorkProgress& progress = {})
      : SceneTextures(device, scene, buildSceneTree(scene, device.maxTextureSize(), progress),
                      layout) {}

  // What depends on how surfaces look. What takes long to make is left out where it is as it was.
  struct Surfaces {
    gl::Texture materials;
    gl::Texture lights;
    std::size_t light_count = 0;
    LightShares light_shares;
    GlossContents gloss;
    std::optional<gl::Texture> gloss_table;
    bool environment_is_map = false;
    std::optional<EnvironmentMap> environment_map;
  };

  // Those of a scene that differs from this one as MaterialChange::numbers says.
  Surfaces surfacesOf(const gl::Device& device, const Scene& scene, const SceneTree& tree,
                      const EffectChange& change = {}) const;
  void take(Surfaces surfaces, const Environment& environment);

  // Sets every uniform that speaks of the scene, for the program in use.
  void bind(gl::Program& program) const;

  std::size_t nodeCount() const { return node_count_; }
  std::size_t stackSize() const { return stack_size_; }  // see stackSizeOf()
  std::size_t bytes() const;
  const std::vector<std::string>& warnings() const { return atlas_.warnings(); }
  double buildSeconds() const { return build_seconds_; }

 private:
  gl::Texture nodes_;
  gl::Texture triangles_;
  gl::Texture normals_;
  gl::Texture attributes_;
  TextureAtlas atlas_;
  gl::Texture materials_;
  gl::Texture lights_;
  gl::Texture punctual_lights_;
  gl::Texture gloss_table_;
  std::optional<GlossContents> gloss_;  // of the table
  std::size_t node_count_ = 0;
  std::size_t stack_size_ = 0;
  std::size_t nodes_per_copy_ = 0;
  std::size_t triangle_count_ = 0;
  Vec3 grid_origin_{0};
  Vec3 grid_cell_{1};
  std::size_t light_count_ = 0;
  std::size_t punctual_light_count_ = 0;
  LightShares light_shares_;
  Vec3 environment_radiance_{0};
  EnvironmentMap environment_map_;
  bool environment_is_map_ = false;
  double build_seconds_ = 0;
};

}  // namespace glimt
