// Models and pictures that nobody here made: sane ones have the counts that are known of them, and
// the others end in a Scene, a picture, or an Error of one line.
#include <algorithm>
#include <cmath>
#include <iostream>
#include <map>
#include <vector>

#include "renderer/core/image_file.h"
#include "renderer/core/image_rgba.h"
#include "renderer/scene/effects_of.h"
#include "renderer/scene/framing.h"
#include "renderer/scene/load_scene.h"
#include "tests/hostile/safe_scene.h"
#include "tests/unit/expect_error.h"
#include "tests/unit/temporary_folder.h"

using namespace glimt;
namespace fs = std::filesystem;

namespace {

const fs::path kShared = GLIMT_SHARED_DIR;

bool missing(const fs::path& path) {
  if (fs::exists(path)) return false;
  std::cout << "skipped: " << path.string() << " is not there\n";
  return true;
}

void checkSafe(const Scene& scene) {
  CHECK(flawOf(scene) == "");
}

void checkSceneOrError(const fs::path& path) {
  CAPTURE(path);
  try {
    checkSafe(loadScene(path));
  } catch (const Error& error) {
    CHECK(error.kind() == ErrorKind::input);
    CHECK(std::string(error.what()).find('\n') == std::string::npos);
  }
}

void checkImageOrError(const fs::path& path) {
  CAPTURE(path);
  try {
    const Image image = readImage(path);
    CHECK(image.pixels.size() ==
          static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height));
  } catch (const Error& error) {
    CHECK(error.kind() == ErrorKind::input);
    CHECK(std::string(error.what()).find('\n') == std::string::npos);
  }
}

void checkTextureOrError(const fs::path& path) {
  CAPTURE(path);
  try {
    const RgbaImage image = decodeRgba(contentOf(path));
    CHECK(image.bytes.size() ==
          4 * static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height));
  } catch (const Error& error) {
    CHECK(error.kind() == ErrorKind::input);
  }
}

// By a model that has it as its only material file.
void checkMtl(const fs::path& path) {
  const TemporaryFolder folder;
  fs::copy_file(path, folder / "x.mtl");
  checkSceneOrError(
      folder.write("x.obj", "mtllib x.mtl\nusemtl a\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n"));
}

std::size_t checkAllIn(const fs::path& folder) {
  std::size_t count = 0;
  for (const fs::directory_entry& entry : fs::recursive_directory_iterator(folder)) {
    const std::string extension = entry.path().extension().string();
    if (extension == ".obj" || extension == ".json" || extension == ".gltf" ||
        extension == ".glb") {
      checkSceneOrError(entry.path());
    } else if (extension == ".mtl") {
      checkMtl(entry.path());
    } else if (extension == ".jpg" || extension == ".jpeg" || extension == ".bmp" ||
               extension == ".tga") {
      checkTextureOrError(entry.path());
    } else if (extension == ".hdr" || extension == ".exr" || extension == ".pfm" ||
               extension == ".png") {
      checkImageOrError(entry.path());
    } else {
      continue;
    }
    ++count;
  }
  return count;
}

}  // namespace

TEST_CASE("awkward and hostile files end in a Scene, a picture or an Error of one line") {
  for (const char* name : {"models/obj-cases", "models/hostile", "models/hdr"}) {
    if (missing(kShared / name)) continue;
    CHECK(checkAllIn(kShared / name) > 0);
  }
}

TEST_CASE("well-known models have the triangles and materials that are known of them") {
  struct Known {
    const char* file;
    std::size_t triangles;
    Vec3 low;
    Vec3 high;
  };
  const std::vector<Known> models = {
      {"cornell/CornellBox-Original.obj", 36, {-1.02, 0, -1.04}, {1, 1.99, 0.99}},
      {"cornell/CornellBox-Sphere.obj", 2188, {-1.02, 0, -1.04}, {1, 1.59, 0.99}},
      {"cornell/CornellBox-Mirror.obj", 36, {-1.02, 0, -1.04}, {1, 1.99, 0.99}},
      {"cornell/CornellBox-Glossy.obj", 1112, {-1.02, -0.0001, -1.04}, {1, 1.59, 0.99}},
      {"cornell/CornellBox-Empty-CO.obj", 12, {-1.02, 0, -1.04}, {1, 1.99, 0.99}},
      {"obj/suzanne.obj", 968, {-3.861, 0.2673, 3.252}, {-1.127, 2.236, 4.955}},
      {"obj/stanford-bunny.obj", 69451, {-0.09469, 0.03299, -0.06187}, {0.06101, 0.1873, 0.0588}},
      {"obj/spot/spot_triangulated.obj",
       5856,
       {-0.4716, -0.7368, -0.6689},
       {0.4716, 0.9536, 1.049}},
      {"obj/spot/spot_quadrangulated.obj",
       5856,
       {-0.4716, -0.7368, -0.6689},
       {0.4716, 0.9536, 1.049}}};
  for (const Known& known : models) {
    const fs::path path = kShared / "models" / known.file;
    if (missing(path)) continue;
    CAPTURE(known.file);
    const Scene scene = loadScene(path);
    checkSafe(scene);
    CHECK(scene.triangles.size() == known.triangles);
    const Bounds bounds = boundsOf(scene);
    for (int c = 0; c < 3; ++c) {
      CHECK(bounds.min[c] == Approx(known.low[c]).margin(5e-3));
      CHECK(bounds.max[c] == Approx(known.high[c]).margin(5e-3));
    }
  }
}

TEST_CASE("the Cornell box has eight materials, one of which emits") {
  for (const char* name : {"Original", "Sphere", "Mirror", "Glossy"}) {
    const fs::path path = kShared / "models/cornell" / ("CornellBox-" + std::string(name) + ".obj");
    if (missing(path)) continue;
    const Scene scene = loadScene(path);
    CAPTURE(name);
    CHECK(scene.materials.size() == 8);
    CHECK(std::count_if(scene.materials.begin(), scene.materials.end(),
                        [](const Material& m) { return m.emission.x > 0; }) == 1);
    CHECK(scene.environment.radiance() == Vec3(0));
    CHECK(has(effectsOf(scene), Effect::triangle_lights));
  }
}

TEST_CASE("awkward OBJ files give the triangles that their makers meant") {
  const std::map<std::string, std::size_t> triangles = {
      {"assimp/box.obj", 12},
      {"assimp/box_mat_with_spaces.obj", 12},
      {"assimp/concave_polygon.obj", 64},
      {"assimp/spider.obj", 1312},
      {"cornell-glossy-missing-light/CornellBox-Glossy.obj", 1112},
      {"rapidobj/cube/cube.obj", 12},
      {"rapidobj/primitives/primitives.obj", 4},
      {"tinyobjloader/catmark_torus_creases0.obj", 64},
      {"tinyobjloader/cornell_box.obj", 36},
      {"tinyobjloader/issue-235-usemtl-then-o.obj", 2},
      {"tinyobjloader/issue-295-trianguation-failure.obj", 28},
      {"tinyobjloader/usemtl-issue-104.obj", 6},
      {"tobj/quad.obj", 5}};
  for (const auto& [name, count] : triangles) {
    const fs::path path = kShared / "models/obj-cases" / name;
    if (missing(path)) continue;
    CAPTURE(name);
    CHECK(loadScene(path).triangles.size() == count);
  }
}

TEST_CASE("the reference scenes load, and cornell exactly as it is rendered") {
  for (const char* name : {"cornell", "knot", "glass", "sky", "mirror_gloss"}) {
    const fs::path path = kShared / "reference" / (std::string(name) + ".scene.json");
    if (missing(path)) continue;
    CAPTURE(name);
    checkSafe(loadScene(path));
  }
  const fs::path path = kShared / "reference/cornell.scene.json";
  if (missing(path)) return;
  const Scene scene = loadScene(path);
  CHECK(scene.triangles.size() == 32);
  CHECK(scene.warnings.empty());
  CHECK(scene.camera.position == Vec3(2.78f, 2.73f, -8.0f));
  CHECK(scene.render.bounces == 4);
  CHECK(scene.environment.radiance() == Vec3(0));
  const auto light = std::find_if(scene.materials.begin(), scene.materials.end(),
                                  [](const Material& m) { return m.name == "light"; });
  REQUIRE(light != scene.materials.end());
  CHECK(light->emission == Vec3(17, 12, 4));
  CHECK_FALSE(light->double_sided);
}
