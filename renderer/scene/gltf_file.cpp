#include "renderer/scene/gltf_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>

#include "renderer/core/error.h"
#include "renderer/core/wording.h"
#include "renderer/scene/framing.h"
#include "renderer/scene/gltf_camera.h"
#include "renderer/scene/gltf_light.h"
#include "renderer/scene/gltf_material.h"
#include "renderer/scene/gltf_mesh.h"
#include "renderer/scene/gltf_variants.h"

namespace glimt {
namespace {

namespace fs = std::filesystem;

std::optional<std::size_t> variantNamed(const std::string& name, const Scene& scene,
                                        const fs::path& path) {
  if (name.empty()) return {};
  const auto found = std::find(scene.variants.begin(), scene.variants.end(), name);
  if (found != scene.variants.end())
    return static_cast<std::size_t>(found - scene.variants.begin());
  const std::string there = scene.variants.empty() ? "the file has none, leave out --variant"
                                                   : "there are " + listed(scene.variants);
  throw Error(ErrorKind::usage, fmt::format("{}: no variant '{}'; {}", printable(path.string()),
                                            printable(name), there));
}

// The one of primitives without a material, where there are none of those.
void dropUnusedDefault(Scene& scene) {
  const std::size_t last = scene.materials.size() - 1;
  const bool used =
      std::any_of(scene.triangles.begin(), scene.triangles.end(),
                  [&](const Triangle& triangle) { return triangle.material == last; });
  if (!used && last > 0) scene.materials.pop_back();
}

}  // namespace

Scene readGltfFile(const fs::path& path, const std::string& variant) {
  const GltfDocument document = readGltfDocument(path);
  Scene scene;
  scene.name = path.stem().string();
  scene.warnings = document.warnings;
  scene.variants = variantNames(document.model);
  const std::optional<std::size_t> chosen = variantNamed(variant, scene, path);
  const GltfInstances instances = instancesOf(document);
  readGltfMaterials(document, scene);
  readGltfMeshes(document, instances.meshes, chosen, scene);
  dropUnusedDefault(scene);
  if (scene.triangles.empty())
    scene.warnings.push_back("the model has no triangles; the picture shows the environment alone");
  scene.cameras =
      camerasOf(document, instances.cameras, boundsOf(scene), scene.origin, scene.warnings);
  scene.lights = lightsOf(document, instances.lights, scene.origin, scene.warnings);
  return scene;
}

}  // namespace glimt
