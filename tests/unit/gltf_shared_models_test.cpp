// glTF files that nobody here made have the triangles that are known of them, or are refused for
// the reason that is known of them.
#include <catch2/catch.hpp>
#include <iostream>
#include <set>

#include "renderer/scene/load_scene.h"
#include "tests/hostile/safe_scene.h"
#include "tests/unit/expect_error.h"

using namespace glimt;
namespace fs = std::filesystem;

namespace {

const fs::path kModels = fs::path(GLIMT_SHARED_DIR) / "models";

struct Known {
  const char* file;
  std::size_t triangles;         // as MANIFEST.md counts them, with instances written out
  std::size_t materials = 0;     // the file's own
  std::size_t without_area = 0;  // of the triangles, which are dropped
  std::size_t cameras = 0;
  std::size_t variants = 0;
};

const std::vector<Known> kKnown = {
    {"gltf/AlphaBlendModeTest/AlphaBlendModeTest.glb", 61, 6},
    {"gltf/AttenuationTest/AttenuationTest.glb", 292, 18},
    {"gltf/Box With Spaces/Box With Spaces.gltf", 12, 1},
    {"gltf/Box-Draco/Box.gltf", 12, 1},
    {"gltf/BoxInterleaved/BoxInterleaved.glb", 12, 1},
    {"gltf/BoxTextured/BoxTextured.glb", 12, 1},
    {"gltf/BoxTexturedNonPowerOfTwo/BoxTexturedNonPowerOfTwo.glb", 12, 1},
    {"gltf/BoxVertexColors/BoxVertexColors.glb", 12},
    {"gltf/Cameras/Cameras.gltf", 2, 0, 0, 2},
    {"gltf/ClearCoatCarPaint/ClearCoatCarPaint.glb", 3072, 1},
    {"gltf/EmissiveStrengthTest/EmissiveStrengthTest.glb", 90, 6},
    {"gltf/MaterialsVariantsShoe/MaterialsVariantsShoe.gltf", 22700, 3, 0, 0, 3},
    {"gltf/MetalRoughSpheresNoTextures/MetalRoughSpheresNoTextures.glb", 1040409, 98, 196},
    {"gltf/MultipleScenes/MultipleScenes.gltf", 2},
    {"gltf/OrientationTest/OrientationTest.glb", 524, 7},
    {"gltf/SimpleInstancing/SimpleInstancing.glb", 125 * 12},
    {"gltf/TextureCoordinateTest/TextureCoordinateTest.glb", 10, 5},
    {"gltf/TextureLinearInterpolationTest/TextureLinearInterpolationTest.glb", 642, 3},
    {"gltf/TextureTransformMultiTest/TextureTransformMultiTest.glb", 3956, 29},
    {"gltf/TextureTransformTest/TextureTransformTest.gltf", 24, 9},
    {"gltf/ToyCar/ToyCar.gltf", 108936, 3, 0, 8},
    {"gltf/TriangleWithoutIndices/TriangleWithoutIndices.gltf", 1},
    {"gltf/Unicode❤♻Test/Unicode❤♻Test.glb", 2, 1},
    {"gltf/UnlitTest/UnlitTest.glb", 88, 2},
    {"gltf-blender-io/00_empty_scene/00_empty_scene.gltf", 0},
    {"gltf-blender-io/00_no_scene/00_no_scene.gltf", 12, 1},
    {"gltf-blender-io/04_lights/04_lights.gltf", 2, 1},
    {"gltf-blender-io/09_texture_transform/09_texture_transform.gltf", 2, 1},
    {"gltf-blender-io/15_transmission/15_transmission.gltf", 4800, 5},
    {"gltf-blender-io/16_volume/16_volume.gltf", 296, 20},
    {"gltf-blender-io/17_ior/17_ior.gltf", 60, 5},
    {"gltf-blender-io/18_variants/18_variants.gltf", 12, 5, 0, 0, 2},
    {"gltf-blender-io/22_vertex_color/22_vertex_color.gltf", 5},
    {"vehicles/harley-seventy-two/motorcycle.glb", 45472, 17, 12},
    {"vehicles/kenney-motorcycle/vehicle-motorcycle.glb", 960, 1},
    {"xmas/christmas-tree.glb", 14104, 17}};

}  // namespace

TEST_CASE("well-known glTF models have the triangles and materials that are known of them") {
  for (const Known& known : kKnown) {
    const fs::path path = kModels / known.file;
    if (!fs::exists(path)) {
      std::cout << "skipped: " << path.string() << " is not there\n";
      continue;
    }
    CAPTURE(known.file);
    const Scene scene = loadScene(path);
    CHECK(flawOf(scene) == "");
    CHECK(scene.triangles.size() + known.without_area == known.triangles);
    const bool has_default = !scene.materials.empty() && scene.materials.back().name == "default";
    CHECK(scene.materials.size() - (has_default ? 1 : 0) == known.materials);
    CHECK(scene.cameras.size() == known.cameras);
    CHECK(scene.variants.size() == known.variants);
  }
}

TEST_CASE("a glTF model that requires what glimt does not read is refused by its name") {
  const fs::path path = kModels / "gltf-blender-io/14_emission_strength/14_emission_strength.gltf";
  if (!fs::exists(path)) {
    std::cout << "skipped: " << path.string() << " is not there\n";
    return;
  }
  const std::string message = messageOf(ErrorKind::input, [&] { loadScene(path); });
  CHECK(message.find("KHR_materials_pbrSpecularGlossiness") != std::string::npos);
}

// 1899 plants of 4032 triangles on two of ground.
TEST_CASE("a forest of glTF instances is written out", "[long]") {
  const fs::path path = kModels / "gltf-blender-io/24_gpu_instancing/24_gpu_instancing.gltf";
  if (!fs::exists(path)) {
    std::cout << "skipped: " << path.string() << " is not there\n";
    return;
  }
  const Scene scene = loadScene(path);
  CHECK(flawOf(scene) == "");
  CHECK(scene.triangles.size() == 7656770);
}
