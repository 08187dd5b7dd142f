// Cameras, lights and variants of glTF files.
#include <catch2/catch.hpp>
#include <cmath>

#include "renderer/scene/load_scene.h"
#include "tests/unit/expect_error.h"
#include "tests/unit/gltf_text.h"
#include "tests/unit/temporary_folder.h"

using namespace glimt;
using Json = GltfText::Json;

namespace {

constexpr float kPi = 3.14159265f;
const float kHalf = std::sqrt(0.5f);
// A quarter turn about +y: what looks along -z looks along -x.
const Json kQuarterTurn = {0, kHalf, 0, kHalf};

GltfText oneTriangle() {
  GltfText gltf;
  gltf.triangle();
  gltf.append("nodes", {{"mesh", 0}});
  return gltf;
}

Scene load(const GltfText& gltf, const LoadSettings& settings = {}) {
  const TemporaryFolder folder;
  return loadScene(folder.write("model.gltf", gltf.text()), settings);
}

void checkNear(const Vec3& a, const Vec3& b) {
  for (int c = 0; c < 3; ++c) CHECK(a[c] == Approx(b[c]).margin(1e-6));
}

}  // namespace

TEST_CASE("the first camera of a glTF is the scene's, unless a scene file places one") {
  GltfText gltf = oneTriangle();
  gltf.root["cameras"] = {
      {{"type", "perspective"}, {"perspective", {{"yfov", kPi / 3}, {"znear", 0.1}}}},
      {{"type", "orthographic"},
       {"orthographic", {{"xmag", 3}, {"ymag", 2}, {"znear", 0.1}, {"zfar", 9}}}}};
  gltf.append("nodes", {{"camera", 0},
                        {"name", "side"},
                        {"translation", {5, 0, 0}},
                        {"scale", {2, 3, 4}},
                        {"rotation", kQuarterTurn}});
  gltf.append("nodes", {{"camera", 1}, {"translation", {0, 0, 3}}});
  const TemporaryFolder folder;
  folder.write("model.gltf", gltf.text());
  const Scene scene = loadScene(folder / "model.gltf");
  REQUIRE(scene.cameras.size() == 2);
  CHECK(scene.cameras[0].name == "side");
  const Camera& camera = scene.camera;
  CHECK(camera.position == Vec3(5, 0, 0));
  CHECK(camera.vertical_fov == Approx(60));
  CHECK(camera.orthographic_height == 0);
  checkNear(glm::normalize(camera.target - camera.position), Vec3(-1, 0, 0));
  checkNear(camera.up, Vec3(0, 1, 0));
  CHECK(scene.cameras[1].camera.orthographic_height == 4);
  checkNear(scene.cameras[1].camera.position, Vec3(0, 0, 3));
  const Scene placed = loadScene(folder.write(
      "x.scene.json", R"({"model": "model.gltf", "camera": {"position": [0, 0, 9]}})"));
  CHECK(placed.camera.position == Vec3(0, 0, 9));
}

TEST_CASE("glTF cameras that cannot be looked through are left out with a warning") {
  GltfText gltf = oneTriangle();
  gltf.root["cameras"] = {{{"type", "perspective"}, {"perspective", {{"yfov", 0}, {"znear", 1}}}},
                          {{"type", "perspective"}, {"perspective", {{"yfov", 1}, {"znear", 1}}}}};
  gltf.append("nodes", {{"camera", 0}, {"name", "a"}});
  gltf.append("nodes", {{"camera", 1}, {"name", "b"}, {"scale", {0, 0, 0}}});
  const Scene scene = load(gltf);
  CHECK(scene.cameras.empty());
  REQUIRE_FALSE(scene.warnings.empty());
  CHECK(scene.warnings[0].find("'a' and 'b'") != std::string::npos);
}

TEST_CASE("the lights of KHR_lights_punctual have their place, direction and numbers") {
  GltfText gltf = oneTriangle();
  gltf.root["extensions"]["KHR_lights_punctual"]["lights"] = {
      {{"type", "point"}, {"color", {1, 0.5, 0}}, {"intensity", 10}, {"range", 4}},
      {{"type", "spot"}, {"spot", {{"innerConeAngle", 0.25}, {"outerConeAngle", 0.5}}}},
      {{"type", "directional"}, {"name", "sun"}, {"intensity", 3}}};
  const auto node = [&](int light, Json more) {
    more["extensions"] = {{"KHR_lights_punctual", {{"light", light}}}};
    gltf.append("nodes", more);
  };
  node(0, {{"translation", {1, 2, 3}}, {"scale", {9, 9, 9}}});
  node(1, {{"rotation", kQuarterTurn}});
  node(2, Json::object());
  const Scene scene = load(gltf);
  REQUIRE(scene.lights.size() == 3);
  const PunctualLight& point = scene.lights[0];
  CHECK(point.kind == PunctualLight::Kind::point);
  CHECK(point.position == Vec3(1, 2, 3));
  CHECK(point.intensity == Vec3(10, 5, 0));
  CHECK(point.range == 4);
  const PunctualLight& spot = scene.lights[1];
  CHECK(spot.kind == PunctualLight::Kind::spot);
  checkNear(spot.direction, Vec3(-1, 0, 0));
  CHECK(spot.inner_cone == 0.25f);
  CHECK(spot.outer_cone == 0.5f);
  CHECK(spot.intensity == Vec3(1));
  const PunctualLight& sun = scene.lights[2];
  CHECK(sun.kind == PunctualLight::Kind::directional);
  CHECK(sun.name == "sun");
  checkNear(sun.direction, Vec3(0, 0, -1));
  CHECK(sun.intensity == Vec3(3));
}

TEST_CASE("glTF lights that do not exist are refused") {
  GltfText gltf = oneTriangle();
  gltf.append("nodes", {{"extensions", {{"KHR_lights_punctual", {{"light", 7}}}}}});
  CHECK(messageOf(ErrorKind::input, [&] { load(gltf); }).find("light 7") != std::string::npos);
  gltf.root["nodes"][1]["extensions"]["KHR_lights_punctual"]["light"] = 0;
  gltf.root["extensions"]["KHR_lights_punctual"]["lights"] = {{{"type", "area"}}};
  CHECK(messageOf(ErrorKind::input, [&] { load(gltf); }).find("'area'") != std::string::npos);
}

TEST_CASE("a variant gives primitives its materials, and an unknown one is told the known ones") {
  GltfText gltf;
  gltf.root["materials"] = {{{"name", "plain"}}, {{"name", "red"}}};
  gltf.root["extensions"]["KHR_materials_variants"]["variants"] = {{{"name", "day"}},
                                                                   {{"name", "night"}}};
  const Json mappings = {{{"material", 1}, {"variants", {1}}}};
  gltf.triangle(
      {{"material", 0}, {"extensions", {{"KHR_materials_variants", {{"mappings", mappings}}}}}});
  gltf.append("nodes", {{"mesh", 0}});
  const auto material = [&](const std::string& variant) {
    const Scene scene = load(gltf, {variant, {}});
    return scene.materials.at(scene.triangles.at(0).material).name;
  };
  CHECK(load(gltf).variants == std::vector<std::string>{"day", "night"});
  CHECK(material("") == "plain");
  CHECK(material("day") == "plain");
  CHECK(material("night") == "red");
  const std::string message = messageOf(ErrorKind::usage, [&] { material("dusk"); });
  CHECK(message.find("'dusk'") != std::string::npos);
  CHECK(message.find("'day' and 'night'") != std::string::npos);
  const TemporaryFolder folder;
  const auto obj = folder.write("x.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
  messageOf(ErrorKind::usage, [&] { loadScene(obj, {"night", {}}); });
}
