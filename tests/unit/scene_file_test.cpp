// The *.scene.json.
#include <fmt/format.h>

#include <cmath>

#include "renderer/core/image_file.h"
#include "renderer/scene/framing.h"
#include "renderer/scene/load_scene.h"
#include "tests/unit/expect_error.h"
#include "tests/unit/temporary_folder.h"

using namespace glimt;
namespace fs = std::filesystem;

namespace {

// A folder with a model of two materials, "wall" and "lamp", for scene files to name.
class SceneFolder : public TemporaryFolder {
 public:
  SceneFolder() {
    write("model.mtl", "newmtl wall\nKd 0.5 0.5 0.5\nnewmtl lamp\nKd 0 0 0\nKe 1 2 3\n");
    write("model.obj",
          "mtllib model.mtl\nv -1 -1 0\nv 1 -1 0\nv 0 1 0\nusemtl wall\nf 1 2 3\nusemtl lamp\n"
          "f 3 2 1\n");
  }

  // `rest` follows the key "model".
  Scene load(const std::string& rest) const {
    const std::string comma = rest.empty() ? "" : ", ";
    return loadScene(write("test.scene.json", "{\"model\": \"model.obj\"" + comma + rest + "}"));
  }

  std::string error(const std::string& rest) const {
    return messageOf(ErrorKind::input, [&] { load(rest); });
  }
};

bool warns(const Scene& scene, const std::string& about) {
  for (const std::string& warning : scene.warnings) {
    CHECK(warning.find('\n') == std::string::npos);
    if (warning.find(about) != std::string::npos) return true;
  }
  return false;
}

const Material& named(const Scene& scene, const std::string& name) {
  for (const Material& material : scene.materials) {
    if (material.name == name) return material;
  }
  FAIL("no material " << name);
  return scene.materials.front();
}

}  // namespace

TEST_CASE("a scene file needs nothing but a model, which it names relative to itself") {
  const SceneFolder folder;
  const Scene scene = folder.load("");
  CHECK(scene.name == "test");
  CHECK(scene.triangles.size() == 2);
  CHECK(scene.warnings.empty());
  folder.write("deep/er/other.scene.json", R"({"model": "../../model.obj"})");
  CHECK(loadScene(folder / "deep/er/other.scene.json").triangles.size() == 2);
}

TEST_CASE("everything that a scene file says arrives in the scene") {
  const SceneFolder folder;
  const Scene scene = folder.load(R"(
    "camera": {"position": [1, 2, 8], "target": [1, 2, 7], "up": [0, 2, 1], "vertical_fov": 39.5},
    "environment": {"color": [1, 0.5, 0.25], "strength": 2, "rotation": -30},
    "materials": {"lamp": {"double_sided": false, "emission": [17, 12, 4]},
                  "wall": {"base_color": [0.25, 0, 1]}},
    "render": {"size": [640, 480], "bounces": 7, "exposure": -1.5})");
  CHECK(scene.camera.position == Vec3(1, 2, 8));
  CHECK(scene.camera.target == Vec3(1, 2, 7));
  CHECK(scene.camera.up == Vec3(0, 2, 1));
  CHECK(scene.camera.vertical_fov == 39.5f);
  CHECK(scene.environment.radiance() == Vec3(2, 1, 0.5f));
  CHECK(named(scene, "lamp").emission == Vec3(17, 12, 4));
  CHECK_FALSE(named(scene, "lamp").double_sided);
  CHECK(named(scene, "lamp").base_color == Vec3(0));
  CHECK(named(scene, "wall").base_color == Vec3(0.25f, 0, 1));
  CHECK(scene.render.size == std::array<int, 2>{640, 480});
  CHECK(scene.render.bounces == 7);
  CHECK(scene.render.exposure == -1.5f);
  CHECK(scene.warnings.empty());
}

TEST_CASE("what a scene file does not say about the camera is framed") {
  const SceneFolder folder;
  const Scene by_fov = folder.load(R"("camera": {"vertical_fov": 10})");
  CHECK(by_fov.camera.vertical_fov == 10);
  CHECK(by_fov.camera.target == Vec3(0));
  CHECK(by_fov.camera.position.z > 10);
  const Scene by_position = folder.load(R"("camera": {"position": [5, 0, 0]})");
  CHECK(by_position.camera.position == Vec3(5, 0, 0));
  CHECK(by_position.camera.target == Vec3(0));
  const Scene by_target = folder.load(R"("camera": {"target": [0, 1, 0]})");
  CHECK(by_target.camera.target == Vec3(0, 1, 0));
  CHECK(by_target.camera.position.y == 1);
  const Scene narrow = folder.load(R"("render": {"size": [100, 400]})");
  CHECK(narrow.camera.position.z > 3.9f * folder.load("").camera.position.z);
}

TEST_CASE("a model that lies flat is framed from above, one that stands from the front") {
  const auto direction = [](const Vec3& size) {
    Bounds bounds;
    bounds.include(-0.5f * size);
    bounds.include(0.5f * size);
    return glm::normalize(framed(bounds, 1).position);
  };
  CHECK(glm::distance(direction({4, 0, 4}), Vec3(0, 1, 1) * std::sqrt(0.5f)) < 1e-6f);
  CHECK(glm::distance(direction({4, 0.1f, 1}), Vec3(0, 1, 1) * std::sqrt(0.5f)) < 1e-6f);
  CHECK(direction({4, 4, 0}) == Vec3(0, 0, 1));
  CHECK(direction({4, 0.4f, 4}) == Vec3(0, 0, 1));
}

TEST_CASE("looking straight up or down works without saying where up is") {
  const SceneFolder folder;
  const Scene down = folder.load(R"("camera": {"position": [0, 9, 0], "target": [0, 0, 0]})");
  CHECK(down.camera.up == Vec3(0, 0, -1));
  const Scene up = folder.load(R"("camera": {"position": [0, -9, 0], "target": [0, 0, 0]})");
  CHECK(up.camera.up == Vec3(0, 0, 1));
  const Scene along =
      folder.load(R"("camera": {"position": [0, 0, 9], "target": [0, 0, 0], "up": [0, 0, 3]})");
  CHECK(along.camera.up == Vec3(0, 1, 0));
}

TEST_CASE("the camera is in the coordinates of the model's file, far from their origin too") {
  const TemporaryFolder folder;
  folder.write("model.obj", "v 4e7 0 0\nv 40000001 0 0\nv 4e7 1 0\nf 1 2 3\n");
  const auto load = [&](const char* camera) {
    return loadScene(folder.write(
        "far.scene.json", fmt::format(R"({{"model": "model.obj", "camera": {{{}}}}})", camera)));
  };
  const Scene scene = load(R"("position": [40000000.25, 0.5, 3], "target": [40000000.25, 0.5, 0])");
  CHECK(scene.origin == glm::dvec3(40000000.5, 0.5, 0));
  CHECK(scene.camera.position == Vec3(-0.25f, 0, 3));
  CHECK(scene.camera.target == Vec3(-0.25f, 0, 0));
  CHECK_THAT(messageOf(ErrorKind::input, [&] { load(R"("position": [-4e8, 0, 0])"); }),
             Catch::EndsWith("camera.position is farther than 100,000 km from the model; move it "
                             "closer"));
}

TEST_CASE("a camera that is where it looks, or without an up, is an error") {
  const SceneFolder folder;
  CHECK_THAT(folder.error(R"("camera": {"position": [1, 1, 1], "target": [1, 1, 1]})"),
             Catch::Contains("camera.target must be another point than camera.position"));
  CHECK_THAT(folder.error(R"("camera": {"position": [0, 0, 0]})"),
             Catch::Contains("the camera is where it looks"));
  CHECK_THAT(folder.error(R"("camera": {"up": [0, 0, 0]})"),
             Catch::Contains("camera.up must be a direction"));
}

TEST_CASE("unknown keys are errors that name the key and the nearest known one") {
  const SceneFolder folder;
  CHECK_THAT(folder.error(R"("camra": {})"),
             Catch::Contains("unknown key \"camra\"; did you mean \"camera\"?"));
  CHECK_THAT(folder.error(R"("camera": {"fov": 40})"),
             Catch::Contains("unknown key \"fov\" in camera") &&
                 Catch::Contains("position, target, up, vertical_fov"));
  CHECK_THAT(folder.error(R"("materials": {"wall": {"base_colour": [1, 1, 1]}})"),
             Catch::Contains("in materials.wall; did you mean \"base_color\"?"));
  CHECK_THAT(folder.error(R"("environment": {"colour": [1, 1, 1]})"), Catch::Contains("\"color\""));
  CHECK_THAT(folder.error(R"("render": {"sice": [1, 1]})"), Catch::Contains("\"size\""));
  CHECK_THAT(folder.error("\"a\\nb\\u001b\": 1"), Catch::Contains("unknown key \"a?b?\""));
}

TEST_CASE("values of a wrong type or out of range are errors that name key, rule and value") {
  const SceneFolder folder;
  CHECK_THAT(
      folder.error(R"("camera": {"vertical_fov": "wide"})"),
      Catch::EndsWith("camera.vertical_fov must be a number between 0 and 180, not \"wide\""));
  for (const char* rest : {R"("camera": 1)",
                           R"("camera": null)",
                           R"("camera": {"vertical_fov": 0})",
                           R"("camera": {"vertical_fov": 180})",
                           R"("camera": {"vertical_fov": 1e-60})",
                           R"("camera": {"vertical_fov": 179.9999999999})",
                           R"("camera": {"position": [1, 2]})",
                           R"("camera": {"position": [1, 2, "3"]})",
                           R"("camera": {"position": [1, 2, 1e30]})",
                           R"("camera": {"up": true})",
                           R"("environment": [])",
                           R"("environment": {"color": 1})",
                           R"("environment": {"color": [1, 1, -1]})",
                           R"("environment": {"strength": -1})",
                           R"("environment": {"strength": 1e39})",
                           R"("environment": {"rotation": "left"})",
                           R"("environment": {"image": 3})",
                           R"("environment": {"image": ""})",
                           R"("materials": [])",
                           R"("materials": {"wall": 1})",
                           R"("materials": {"wall": {"base_color": [2, 0, 0]}})",
                           R"("materials": {"wall": {"emission": [-1, 0, 0]}})",
                           R"("materials": {"wall": {"double_sided": 1}})",
                           R"("materials": {"wall": {"metallic": 2}})",
                           R"("materials": {"wall": {"roughness": -1}})",
                           R"("materials": {"wall": {"ior": 0.5}})",
                           R"("materials": {"wall": {"transmission": "yes"}})",
                           R"("materials": {"wall": {"clearcoat": []}})",
                           R"("render": {"size": [512]})",
                           R"("render": {"size": [0, 512]})",
                           R"("render": {"size": [99999, 512]})",
                           R"("render": {"size": [1.5, 512]})",
                           R"("render": {"bounces": -1})",
                           R"("render": {"bounces": 2.5})",
                           R"("render": {"exposure": "bright"})",
                           R"("render": {"exposure": 1e9})"}) {
    CAPTURE(rest);
    CHECK_THAT(folder.error(rest), Catch::Contains("test.scene.json:1: ") &&
                                       Catch::Contains(" must be ") && Catch::Contains(", not "));
  }
}

TEST_CASE("a scene file that is no JSON object with a model is an error, with the line if known") {
  const SceneFolder folder;
  const auto error = [&](const std::string& text) {
    return messageOf(ErrorKind::input, [&] { loadScene(folder.write("bad.scene.json", text)); });
  };
  CHECK_THAT(error("{\n\"model\": \"model.obj\",\n}\n"), Catch::Contains("bad.scene.json:3: "));
  CHECK_THAT(error("{\n\"model\": \"model.obj\",\n\"camera\": {\n\"fov\": 1}}"),
             Catch::Contains("bad.scene.json:4: unknown key \"fov\" in camera"));
  CHECK_THAT(error("{\"model\": \"model.obj\",\n\"render\":\n{\"bounces\":\n-1}}"),
             Catch::Contains("bad.scene.json:3: render.bounces must be"));
  CHECK_THAT(error("{\n\"model\": \"model.obj\",\n\"camera\": 7}"),
             Catch::Contains("bad.scene.json:3: camera must be"));
  CHECK_THAT(error(""), Catch::Contains("no valid JSON"));
  CHECK_THAT(error("{\"model\": \"\xff\xfe\"}"), Catch::Contains("no valid JSON"));
  CHECK_THAT(error(std::string("{\0}", 3)), Catch::Contains("no valid JSON"));
  CHECK_THAT(error("[1, 2]"), Catch::Contains("must be an object"));
  CHECK_THAT(error("{}"), Catch::Contains("\"model\" is missing"));
  CHECK_THAT(error("{\"model\": 3}"), Catch::Contains("model must be a text"));
  CHECK_THAT(error("{\"model\": \"none.obj\"}"), Catch::Contains("none.obj: no such file"));
  CHECK_THAT(error("{\"model\": \"bad.scene.json\"}"), Catch::Contains("unknown kind of model"));
  CHECK_THAT(error("{\"model\": \"model.obj\", \"render\": {\"exposure\": 1e999}}"),
             Catch::Contains("too large"));
}

TEST_CASE("JSON nested a million deep is an error and no stack overflow") {
  const SceneFolder folder;
  for (const char* open : {"[", "{\"a\":"}) {
    std::string text = "{\"model\": ";
    for (int i = 0; i < 1'000'000; ++i) text += open;
    CHECK_THAT(
        messageOf(ErrorKind::input, [&] { loadScene(folder.write("deep.scene.json", text)); }),
        Catch::Contains("nested too deeply"));
  }
}

TEST_CASE("materials that the model does not have are a warning that lists those it has") {
  const SceneFolder folder;
  const Scene scene = folder.load(R"("materials": {"wal": {"base_color": [1, 0, 0]}})");
  CHECK(warns(scene, "no material 'wal'; it has 'wall' and 'lamp'"));
}

TEST_CASE("a material that the model names and no MTL defines can be said in the scene file") {
  const SceneFolder folder;
  folder.write("bare.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nusemtl gold\nf 1 2 3\n");
  const Scene scene = loadScene(
      folder.write("bare.scene.json",
                   R"({"model": "bare.obj", "materials": {"gold": {"base_color": [1, 1, 0]}}})"));
  CHECK(named(scene, "gold").base_color == Vec3(1, 1, 0));
}

TEST_CASE("metal, gloss and glass are taken from the file") {
  const SceneFolder folder;
  const Scene scene = folder.load(
      R"("materials": {"wall": {"metallic": 1, "roughness": 0.3}, "lamp": {"transmission": 1, "ior": 1.4}})");
  CHECK(scene.warnings.empty());
  CHECK(named(scene, "wall").metallic == 1);
  CHECK(named(scene, "wall").roughness == 0.3f);
  CHECK(named(scene, "lamp").transmission == 1);
  CHECK(named(scene, "lamp").ior == 1.4f);
}

TEST_CASE("coats, fibres, thin walls and absorption are taken from the file") {
  const SceneFolder folder;
  const Scene scene = folder.load(
      R"("materials": {"wall": {"clearcoat": 0.5, "clearcoat_roughness": 0.1,
         "sheen_color": [0.1, 0.2, 0.3], "sheen_roughness": 0.4},
         "lamp": {"transmission": 1, "thin_walled": true, "attenuation_color": [0.5, 0.6, 0.7],
         "attenuation_distance": 2, "specular": 0.25}})");
  CHECK(scene.warnings.empty());
  CHECK(named(scene, "wall").clearcoat == 0.5f);
  CHECK(named(scene, "wall").clearcoat_roughness == 0.1f);
  CHECK(named(scene, "wall").sheen_color == Vec3(0.1f, 0.2f, 0.3f));
  CHECK(named(scene, "wall").sheen_roughness == 0.4f);
  CHECK(named(scene, "wall").specular == 0);
  CHECK(named(scene, "lamp").thin_walled);
  CHECK(named(scene, "lamp").attenuation_color == Vec3(0.5f, 0.6f, 0.7f));
  CHECK(named(scene, "lamp").attenuation_distance == 2);
  CHECK(named(scene, "lamp").specular == 0.25f);
}

TEST_CASE("a material is a Lambert surface until the file speaks of its gloss") {
  const SceneFolder folder;
  CHECK(
      named(folder.load(R"("materials": {"wall": {"base_color": [1, 1, 1]}})"), "wall").specular ==
      0);
  CHECK(named(folder.load(R"("materials": {"wall": {"roughness": 0.5}})"), "wall").specular == 1);
}

TEST_CASE(
    "an environment that is given as black stays black, with a warning if nothing else gives "
    "light") {
  const SceneFolder folder;
  const Scene lit = folder.load(R"("environment": {"color": [0, 0, 0]})");
  CHECK(lit.environment.radiance() == Vec3(0));
  CHECK(lit.warnings.empty());
  const Scene dark = folder.load(
      R"("environment": {"color": [0, 0, 0]}, "materials": {"lamp": {"emission": [0, 0, 0]}})");
  CHECK(dark.environment.radiance() == Vec3(0));
  CHECK(warns(dark, "the picture will be black"));
  const Scene unsaid = folder.load(R"("materials": {"lamp": {"emission": [0, 0, 0]}})");
  CHECK(unsaid.environment.radiance() == Vec3(1));
  CHECK(folder.load(R"("environment": {"strength": 0.5})").environment.radiance() == Vec3(0.5f));
}

TEST_CASE("an environment has its picture, what multiplies it, and its rotation") {
  const SceneFolder folder;
  writeImage(folder / "sky.pfm", {2, 2, {Vec3(1, 0, 4), Vec3(3, 0, 4), Vec3(0), Vec3(0, 8, 4)}});
  const Environment sky =
      folder.load(R"("environment": {"image": "sky.pfm", "strength": 0.5, "rotation": 30})")
          .environment;
  CHECK(sky.image.width == 2);
  CHECK(sky.image.pixels[1] == Vec3(3, 0, 4));
  CHECK(sky.radiance() == Vec3(0.5f));
  CHECK(sky.rotation == 30);
  CHECK(sky.shines());
  CHECK_THAT(folder.error(R"("environment": {"image": "none.hdr"})"),
             Catch::Contains("none.hdr: cannot read (no such file)"));
  CHECK_THAT(folder.error(R"("environment": {"image": "sky.tga"})"), Catch::Contains(".tga"));
}

TEST_CASE("what is no radiance in an environment's picture becomes black, with a warning") {
  const SceneFolder folder;
  const float nan = std::numeric_limits<float>::quiet_NaN();
  writeImage(folder / "sky.pfm", {2, 1, {Vec3(nan, 1, 2), Vec3(-1, 3, 4)}});
  const Scene scene = folder.load(R"("environment": {"image": "sky.pfm"})");
  CHECK(scene.environment.image.pixels[0] == Vec3(0, 1, 2));
  CHECK(scene.environment.image.pixels[1] == Vec3(0, 3, 4));
  CHECK(warns(scene, "sky.pfm: pixels that are negative"));
  writeImage(folder / "black.pfm", {1, 1, {Vec3(0)}});
  CHECK_FALSE(folder.load(R"("environment": {"image": "black.pfm"})").environment.shines());
}
