#include "app/viewer/edited_scene.h"

#include <catch2/catch.hpp>
#include <fstream>

#include "app/viewer/render_command_line.h"
#include "renderer/core/file.h"
#include "tests/unit/temporary_folder.h"

using namespace glimt;

namespace {

constexpr const char* kModel =
    "mtllib two.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nusemtl red\nf 1 2 3\nusemtl blue\nf 1 2 "
    "4\n";
constexpr const char* kMaterials = "newmtl red\nKd 0.8 0.1 0.1\nnewmtl blue\nKd 0.1 0.1 0.8\n";

LoadedScene load(const std::filesystem::path& path) {
  return loadWithTree({path, {}}, nullptr, [](float) {});
}

Look lookOf(const LoadedScene& loaded) {
  return lookOf(loaded.scene, "", 4, 0, Tone::srgb);
}

Camera someCamera() {
  Camera camera;
  camera.position = {1.5f, 2.25f, 5};
  camera.target = {0.5f, 0.25f, 0};
  camera.vertical_fov = 35;
  return camera;
}

}  // namespace

TEST_CASE("a saved look is read back as it was: materials, environment, camera, display") {
  const TemporaryFolder folder;
  writeFile(folder / "two.obj", kModel);
  writeFile(folder / "two.mtl", kMaterials);
  const LoadedScene loaded = load(folder / "two.obj");
  Look look = lookOf(loaded);
  look.materials[0].base_color = {0.25f, 0.5f, 0.75f};
  look.materials[1].roughness = 0.3f;
  look.materials[1].metallic = 1;
  look.materials[1].specular = 0.5f;
  look.environment_strength = 1.5f;
  look.environment_rotation = -30;
  look.bounces = 7;
  look.exposure = -0.5f;
  look.tone = Tone::agx;
  const std::filesystem::path file = editedSceneName(loaded.choice.path);
  CHECK(file.filename() == "two.scene.json");
  const EditedScene edited = editedScene(loaded, look, someCamera(), {320, 200});
  CHECK(edited.warnings.empty());
  writeFile(file, edited.file.dump());

  const Scene scene = loadScene(file);
  CHECK(scene.materials == look.materials);
  CHECK(scene.environment.strength == look.environment_strength);
  CHECK(scene.environment.rotation == look.environment_rotation);
  CHECK(scene.environment.image.pixels == loaded.scene.environment.image.pixels);
  CHECK(scene.camera.position == someCamera().position);
  CHECK(scene.camera.target == someCamera().target);
  CHECK(scene.camera.vertical_fov == 35);
  CHECK(scene.render.bounces == 7);
  CHECK(scene.render.exposure == -0.5f);
  CHECK(scene.render.tone == Tone::agx);
  CHECK(scene.render.size == std::array{320, 200});
}

TEST_CASE("what a scene file says besides is kept, and the file itself is left alone") {
  const TemporaryFolder folder;
  writeFile(folder / "two.obj", kModel);
  writeFile(folder / "two.mtl", kMaterials);
  writeFile(folder / "a.scene.json",
            R"({"model": "two.obj", "environment": {"image": "sun-sky", "turbidity": 5},
                "lights": [{"position": [0, 3, 0]}], "materials": {"red": {"ior": 1.7}}})");
  const LoadedScene loaded = load(folder / "a.scene.json");
  Look look = lookOf(loaded);
  look.materials[0].base_color = {0, 1, 0};
  const std::filesystem::path file = editedSceneName(loaded.choice.path);
  CHECK(file.filename() == "a-edited.scene.json");
  writeFile(file, editedScene(loaded, look, someCamera(), {64, 64}).file.dump());
  CHECK(editedSceneName(loaded.choice.path).filename() == "a-edited-2.scene.json");

  const Scene scene = loadScene(file);
  CHECK(scene.lights.size() == 1);
  CHECK(scene.materials == look.materials);
  CHECK(scene.environment.image.pixels == loaded.scene.environment.image.pixels);
}

TEST_CASE("a material that no name leads to is not saved, and that is told") {
  const TemporaryFolder folder;
  writeFile(folder / "two.obj", kModel);
  writeFile(folder / "two.mtl", kMaterials);
  LoadedScene loaded = load(folder / "two.obj");
  loaded.scene.materials[1].name = loaded.scene.materials[0].name;
  Look look = lookOf(loaded);
  look.materials[1].roughness = 0.2f;
  const EditedScene edited = editedScene(loaded, look, someCamera(), {64, 64});
  CHECK(edited.warnings.size() == 1);
  CHECK_FALSE(edited.file.contains("materials"));
}

TEST_CASE("the command line says what it can, and no more is asked of it") {
  const TemporaryFolder folder;
  writeFile(folder / "two.obj", kModel);
  writeFile(folder / "two.mtl", kMaterials);
  const LoadedScene loaded = load(folder / "two.obj");
  Look look = lookOf(loaded);
  look.exposure = 1.5f;
  CHECK(fitsCommandLine(loaded, look, someCamera()));
  const std::string line = renderCommandLine(loaded, look, someCamera(), {640, 360}, 64);
  CHECK_THAT(line, Catch::StartsWith("glimt render "));
  for (const char* part : {"--eye=1.5,2.25,5", "--target=0.5,0.25,0", "--fov=35", "--exposure=1.5",
                           "--size=640x360", "--spp=64", "-o two.png"})
    CHECK_THAT(line, Catch::Contains(part));
  look.materials[0].roughness = 0.5f;
  CHECK_FALSE(fitsCommandLine(loaded, look, someCamera()));
  Camera lens = someCamera();
  lens.aperture_radius = 0.1f;
  CHECK_FALSE(fitsCommandLine(loaded, lookOf(loaded), lens));
}

TEST_CASE("a word for the shell comes out of it as it went in") {
  CHECK(shellWord("plain/name-1.obj") == "plain/name-1.obj");
  CHECK(shellWord("with space") == "'with space'");
  CHECK(shellWord("it's") == "'it'\\''s'");
  CHECK(shellWord("") == "''");
}
