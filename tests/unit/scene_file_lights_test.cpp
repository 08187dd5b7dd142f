// Lights, cameras and environments of scene files.
#include <cmath>

#include "renderer/scene/effects_of.h"
#include "renderer/scene/load_scene.h"
#include "tests/unit/expect_error.h"
#include "tests/unit/temporary_folder.h"

using namespace glimt;

namespace {

class Folder {
 public:
  Folder() { folder_.write("model.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n"); }
  Scene load(const std::string& rest, const EnvironmentChoice& choice = {}) const {
    return loadScene(folder_.write("test.scene.json", "{\"model\": \"model.obj\",\n" + rest + "}"),
                     {"", choice});
  }
  std::string error(const std::string& rest) const {
    return messageOf(ErrorKind::input, [&] { load(rest); });
  }

 private:
  TemporaryFolder folder_;
};

}  // namespace

TEST_CASE("lights of a scene file arrive in the scene, and then nothing else has to give light") {
  const Folder folder;
  const Scene scene = folder.load(R"("lights": [
    {"position": [1, 2, 3], "intensity": [4, 5, 6], "range": 7, "name": "bulb"},
    {"type": "spot", "direction": [0, 0, -2], "inner_cone": 10, "outer_cone": 20},
    {"type": "directional", "direction": [3, -4, 0]}])");
  REQUIRE(scene.lights.size() == 3);
  CHECK(scene.warnings.empty());
  CHECK(scene.environment.radiance() == Vec3(0));
  CHECK(scene.lights[0].kind == PunctualLight::Kind::point);
  CHECK(scene.lights[0].position == Vec3(1, 2, 3));
  CHECK(scene.lights[0].intensity == Vec3(4, 5, 6));
  CHECK(scene.lights[0].range == 7);
  CHECK(scene.lights[0].name == "bulb");
  CHECK(scene.lights[1].direction == Vec3(0, 0, -1));
  CHECK(scene.lights[1].outer_cone == Approx(0.349066f));
  CHECK(scene.lights[2].direction == Vec3(0.6f, -0.8f, 0));
  CHECK(has(effectsOf(scene), Effect::punctual_lights));
}

TEST_CASE("lights that cannot be, and keys that would do nothing, are errors with the light") {
  const Folder folder;
  CHECK_THAT(folder.error(R"("lights": {})"), Catch::Contains("lights must be an array"));
  CHECK_THAT(folder.error(R"("lights": [{"type": "area"}])"),
             Catch::Contains(":2: lights[0].type must be point, spot or directional"));
  CHECK_THAT(folder.error(R"("lights": [{}, {"intensity": [-1, 0, 0]}])"),
             Catch::Contains("lights[1].intensity"));
  CHECK_THAT(folder.error(R"("lights": [{"outer_cone": 3}])"), Catch::Contains("only a spot"));
  CHECK_THAT(folder.error(R"("lights": [{"type": "spot", "direction": [0, 0, 0]}])"),
             Catch::Contains("lights[0].direction must be a direction"));
  CHECK_THAT(folder.error(R"("lights": [{"type": "spot", "inner_cone": 50}])"),
             Catch::Contains("no larger than outer_cone"));
  CHECK_THAT(folder.error(R"("lights": [{"colour": 1}])"), Catch::Contains("unknown key"));
}

TEST_CASE("a camera has its lens, sharp at the target unless the file says where, or none") {
  const Folder folder;
  const Camera lens = folder
                          .load(R"("camera": {"position": [0, 0, 5], "target": [0, 0, 1],
    "aperture_radius": 0.1, "aperture_blades": 6})")
                          .camera;
  CHECK(lens.aperture_radius == 0.1f);
  CHECK(lens.aperture_blades == 6);
  CHECK(lens.focus_distance == 4);
  const Scene parallel =
      folder.load(R"("camera": {"orthographic_height": 2, "aperture_radius": 1})");
  CHECK(has(effectsOf(parallel), Effect::orthographic));
  CHECK_FALSE(has(effectsOf(parallel), Effect::lens));
  CHECK_THAT(folder.error(R"("camera": {"aperture_blades": 2})"),
             Catch::Contains("0 for a round one, or an integer from 3 to 64"));
  CHECK_THAT(folder.error(R"("camera": {"focus_distance": 0})"), Catch::Contains("above 0"));
}

TEST_CASE("named cameras are read like the camera, and errors name them") {
  const Folder folder;
  const Scene scene = folder.load(
      R"("cameras": {"top": {"position": [0, 9, 0], "target": [0, 0, 0]}, "near": {}})");
  REQUIRE(scene.cameras.size() == 2);
  CHECK(scene.cameras[1].name == "top");
  CHECK(scene.cameras[1].camera.position == Vec3(0, 9, 0));
  CHECK(scene.cameras[0].camera.position == scene.camera.position);
  CHECK_THAT(folder.error(R"("cameras": {"top": {"fov": 3}})"), Catch::Contains("cameras.top"));
}

TEST_CASE("environments that are built in go by their names, and the sky has its sun") {
  const Folder folder;
  CHECK(folder.load(R"("environment": {"image": "studio"})").environment.image.width == 512);
  const auto sky = [&](const std::string& more) {
    return folder.load(R"("environment": {"image": "sun-sky")" + more + "}").environment.image;
  };
  CHECK(sky("").pixels != sky(R"(, "sun_elevation": 10)").pixels);
  CHECK(sky("").pixels != sky(R"(, "sun_rotation": 10)").pixels);
  CHECK(sky("").pixels != sky(R"(, "turbidity": 6)").pixels);
  CHECK_THAT(folder.error(R"("environment": {"image": "studio", "turbidity": 6})"),
             Catch::Contains("only the image \"sun-sky\" has a sun"));
  CHECK_THAT(folder.error(R"("environment": {"image": "sun-sky", "turbidity": 1})"),
             Catch::Contains("between 2 and 10"));
}

TEST_CASE("what the caller chooses wins over the file's environment") {
  const Folder folder;
  const std::string file = R"("environment": {"color": [1, 2, 3], "strength": 4, "rotation": 5})";
  const Environment turned = folder.load(file, {{}, 30.0f, 2.0f}).environment;
  CHECK(turned.color == Vec3(1, 2, 3));
  CHECK(turned.strength == 2);
  CHECK(turned.rotation == 30);
  const Environment other = folder.load(file, {"studio", {}, {}}).environment;
  CHECK(other.color == Vec3(1));
  CHECK(other.strength == 1);
  CHECK(other.rotation == 0);
  CHECK(other.image.width == 512);
}

TEST_CASE("a tone of a scene file is one of those there are") {
  const Folder folder;
  CHECK(folder.load(R"("render": {"tone": "agx"})").render.tone == Tone::agx);
  CHECK_THAT(folder.error(R"("render": {"tone": "film"})"),
             Catch::Contains("render.tone must be srgb, agx or aces, not \"film\""));
}
