#include "renderer/passes/scene_textures.h"

#include <fmt/format.h>

#include <chrono>
#include <cmath>
#include <utility>

#include "renderer/bvh/node_layout.h"
#include "renderer/core/error.h"
#include "renderer/passes/corner_order.h"
#include "renderer/passes/data_texture.h"
#include "renderer/passes/gloss_table.h"
#include "renderer/passes/light_shares.h"
#include "renderer/passes/light_table.h"
#include "renderer/passes/material_texels.h"
#include "renderer/passes/punctual_lights.h"
#include "renderer/passes/vertex_attributes.h"
#include "renderer/scene/effects_of.h"
#include "shaders/layout.h"

namespace glimt {
namespace {

std::vector<Vec4> packTriangles(const Scene& scene, const Bvh& bvh) {
  std::vector<Vec4> texels;
  texels.reserve(scene.triangles.size() * static_cast<std::size_t>(TRIANGLE_TEXELS));
  for (const std::uint32_t index : bvh.order) {
    const Triangle& triangle = scene.triangles[index];
    const auto [first, second, third] = cornerOrder(scene, triangle);
    const Vec3& v0 = scene.positions[triangle.positions[first]];
    const Vec3& v1 = scene.positions[triangle.positions[second]];
    const Vec3& v2 = scene.positions[triangle.positions[third]];
    texels.emplace_back(v0, 1.0f + static_cast<float>(triangle.material));
    texels.emplace_back(v1, static_cast<float>(areaOf(scene, triangle)));
    const bool passable = scene.materials[triangle.material].alpha_mode != AlphaMode::opaque;
    texels.emplace_back(v2, passable ? 1.0f : 0.0f);
  }
  for (const BvhNode& node : bvh.nodes) {
    if (!node.leaf()) continue;
    const std::size_t last = node.first + node.count - 1u;
    texels[last * static_cast<std::size_t>(TRIANGLE_TEXELS)].w *= -1.0f;
  }
  return texels;
}

// As decodeOctahedral in shaders/octahedral.glsl undoes it.
Vec2 encodeOctahedral(const Vec3& v) {
  const Vec2 p = Vec2(v) / (std::abs(v.x) + std::abs(v.y) + std::abs(v.z));
  if (v.z >= 0) return p;
  return {std::copysign(1 - std::abs(p.y), v.x), std::copysign(1 - std::abs(p.x), v.y)};
}

// 1, or -1 where the normals point to the triangle's back. They say how the surface is curved;
// which side is the front is the winding's to say, and some files wind the other way.
float sideOfNormals(const Scene& scene, const Triangle& triangle) {
  const Vec3& a = scene.positions[triangle.positions[0]];
  const Vec3 geometric = glm::cross(scene.positions[triangle.positions[1]] - a,
                                    scene.positions[triangle.positions[2]] - a);
  Vec3 sum(0);
  for (const std::uint32_t normal : triangle.normals) sum += scene.normals[normal];
  return glm::dot(sum, geometric) < 0 ? -1.0f : 1.0f;
}

std::vector<Vec4> packNormals(const Scene& scene, const Bvh& bvh) {
  std::vector<Vec4> texels;
  texels.reserve(scene.triangles.size() * static_cast<std::size_t>(NORMAL_TEXELS));
  for (const std::uint32_t index : bvh.order) {
    const Triangle& triangle = scene.triangles[index];
    if (!triangle.smooth()) {
      texels.resize(texels.size() + static_cast<std::size_t>(NORMAL_TEXELS), Vec4(0));
      continue;
    }
    const float side = sideOfNormals(scene, triangle);
    const auto [first, second, third] = cornerOrder(scene, triangle);
    texels.emplace_back(encodeOctahedral(side * scene.normals[triangle.normals[first]]),
                        encodeOctahedral(side * scene.normals[triangle.normals[second]]));
    texels.emplace_back(encodeOctahedral(side * scene.normals[triangle.normals[third]]),
                        Vec2(1, 0));
  }
  return texels;
}

std::vector<Vec4> packLights(const LightTable& lights, const Bvh& bvh) {
  std::vector<std::uint32_t> place(bvh.order.size());
  for (std::uint32_t i = 0; i < bvh.order.size(); ++i) place[bvh.order[i]] = i;
  std::vector<Vec4> texels;
  for (const LightEntry& entry : lights.entries)
    texels.emplace_back(entry.share, static_cast<float>(place[entry.triangle]),
                        static_cast<float>(place[entry.other_triangle]), 0.0f);
  return texels;
}

NodeLayout layOut(const Bvh& bvh, TreeLayout layout) {
  switch (layout) {
    case TreeLayout::octants:
      return layOutOctants(bvh);
    case TreeLayout::once:
      return layOutOnce(bvh);
    case TreeLayout::pairs:
      return layOutPairs(bvh);
    case TreeLayout::triples:
      return layOutTriples(bvh);
    case TreeLayout::none:
      break;
  }
  return {};
}

void bindData(gl::Program& program, const std::string& name, const gl::Texture& texture) {
  program.set(name, texture);
  const auto width = static_cast<float>(texture.width());
  program.set(name + "Step", Vec2(1 / width, 1 / width / static_cast<float>(texture.height())));
}

}  // namespace

SceneTextures::SceneTextures(const gl::Device& device, const Scene& scene, const SceneTree& tree,
                             TreeLayout layout, const EffectChange& change) {
  const Bvh& bvh = tree.bvh;
  const EffectSet effects = changed(effectsOf(scene), change);
  const auto start = std::chrono::steady_clock::now();
  NodeLayout nodes = layOut(bvh, layout);
  build_seconds_ = tree.build_seconds +
                   std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();

  nodes_ = makeDataTexture(device, std::move(nodes.texels), "tree nodes");
  triangles_ = makeDataTexture(device, packTriangles(scene, bvh), "triangles");
  atlas_ = TextureAtlas(device, scene);
  attributes_ =
      makeDataTexture(device, packAttributes(scene, bvh.order, effects), "vertex attributes");
  std::vector<Vec4> punctual = packPunctualLights(scene);
  punctual_light_count_ = punctual.size() / static_cast<std::size_t>(PUNCTUAL_LIGHT_TEXELS);
  punctual_lights_ = makeDataTexture(device, std::move(punctual), "lights without triangles");
  const bool smooth = !scene.normals.empty();
  normals_ =
      makeDataTexture(device, smooth ? packNormals(scene, bvh) : std::vector<Vec4>(), "normals");
  node_count_ = bvh.nodes.size();
  stack_size_ = stackSizeOf(bvh);
  nodes_per_copy_ = nodes.nodes_per_copy;
  triangle_count_ = scene.triangles.size();
  grid_origin_ = nodes.grid_origin;
  grid_cell_ = nodes.grid_cell;
  take(surfacesOf(device, scene, tree, change), scene.environment);
}

SceneTextures::Surfaces SceneTextures::surfacesOf(const gl::Device& device, const Scene& scene,
                                                  const SceneTree& tree,
                                                  const EffectChange& change) const {
  const EffectSet effects = changed(effectsOf(scene), change);
  const LightTable lights = buildLightTable(scene);
  Surfaces surfaces;
  surfaces.materials = makeDataTexture(device, packMaterials(scene, lights, atlas_), "materials");
  surfaces.lights = makeDataTexture(device, packLights(lights, tree.bvh), "lights");
  surfaces.light_count = lights.entries.size();
  surfaces.light_shares = lightShares(scene, lights);
  surfaces.gloss = glossContentsOf(scene, effects);
  if (!gloss_ || surfaces.gloss != *gloss_)
    surfaces.gloss_table = makeGlossTexture(device, surfaces.gloss);
  surfaces.environment_is_map = has(effects, Effect::environment_map);
  if (!gloss_ || surfaces.environment_is_map != environment_is_map_)
    surfaces.environment_map = EnvironmentMap(device, scene.environment, effects);
  return surfaces;
}

void SceneTextures::take(Surfaces surfaces, const Environment& environment) {
  materials_ = std::move(surfaces.materials);
  lights_ = std::move(surfaces.lights);
  light_count_ = surfaces.light_count;
  light_shares_ = surfaces.light_shares;
  gloss_ = std::move(surfaces.gloss);
  if (surfaces.gloss_table) gloss_table_ = std::move(*surfaces.gloss_table);
  environment_is_map_ = surfaces.environment_is_map;
  if (surfaces.environment_map) environment_map_ = std::move(*surfaces.environment_map);
  environment_map_.turn(environment);
  environment_radiance_ = environment.radiance();
}

void SceneTextures::bind(gl::Program& program) const {
  bindData(program, "uNodes", nodes_);
  bindData(program, "uTriangles", triangles_);
  bindData(program, "uMaterials", materials_);
  bindData(program, "uNormals", normals_);
  bindData(program, "uLights", lights_);
  bindData(program, "uAttributes", attributes_);
  atlas_.bind(program);
  program.set("uGlossTable", gloss_table_);
  program.set("uGlossTableSquares",
              static_cast<float>(gloss_table_.height()) / static_cast<float>(gloss_table_.width()));
  program.set("uNodesPerCopy", static_cast<float>(nodes_per_copy_));
  program.set("uTriangleCount", static_cast<float>(triangle_count_));
  program.set("uGridOrigin", grid_origin_);
  program.set("uGridCell", grid_cell_);
  program.set("uLightCount", static_cast<float>(light_count_));
  bindData(program, "uPunctualLights", punctual_lights_);
  program.set("uPunctualLightCount", static_cast<float>(punctual_light_count_));
  program.set("uLightShares", light_shares_.usual);
  program.set("uLightSharesAlone", light_shares_.alone);
  program.set("uEnvironmentRadiance", environment_radiance_);
  environment_map_.bind(program);
}

std::size_t SceneTextures::bytes() const {
  std::size_t texels = 0;
  for (const gl::Texture* texture :
       {&nodes_, &triangles_, &normals_, &attributes_, &materials_, &lights_, &punctual_lights_})
    texels +=
        static_cast<std::size_t>(texture->width()) * static_cast<std::size_t>(texture->height());
  return texels * sizeof(Vec4) + environment_map_.bytes() + atlas_.bytes();
}

}  // namespace glimt
