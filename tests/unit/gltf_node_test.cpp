// Where the nodes of a glTF file put meshes, cameras and lights.
#include <catch2/catch.hpp>
#include <cmath>

#include "renderer/scene/load_scene.h"
#include "tests/unit/expect_error.h"
#include "tests/unit/gltf_text.h"
#include "tests/unit/temporary_folder.h"

using namespace glimt;
using Json = GltfText::Json;

namespace {

Scene load(const GltfText& gltf) {
  const TemporaryFolder folder;
  return loadScene(folder.write("model.gltf", gltf.text()));
}

std::string refusal(const GltfText& gltf) {
  return messageOf(ErrorKind::input, [&] { load(gltf); });
}

Vec3 corner(const Scene& scene, std::size_t triangle, std::size_t k) {
  return scene.positions[scene.triangles[triangle].positions[k]];
}

Vec3 faceNormal(const Scene& scene, std::size_t triangle) {
  const Vec3 a = corner(scene, triangle, 0);
  return glm::normalize(glm::cross(corner(scene, triangle, 1) - a, corner(scene, triangle, 2) - a));
}

void checkNear(const Vec3& a, const Vec3& b) {
  for (int c = 0; c < 3; ++c) CHECK(a[c] == Approx(b[c]).margin(1e-6));
}

const float kHalf = std::sqrt(0.5f);
// A quarter turn about +y: +x goes to -z, +z to +x.
const Json kQuarterTurn = {0, kHalf, 0, kHalf};

}  // namespace

TEST_CASE("glTF nodes scale, turn and move, in that order, below their parents") {
  GltfText gltf;
  gltf.triangle();
  gltf.append("nodes", {{"children", {1}}, {"translation", {10, 0, 0}}});
  gltf.append(
      "nodes",
      {{"mesh", 0}, {"scale", {2, 3, 4}}, {"rotation", kQuarterTurn}, {"translation", {0, 1, 0}}});
  const Scene scene = load(gltf);
  REQUIRE(scene.triangles.size() == 1);
  checkNear(corner(scene, 0, 0), {10, 1, 0});
  checkNear(corner(scene, 0, 1), {10, 1, -2});
  checkNear(corner(scene, 0, 2), {10, 4, 0});
}

TEST_CASE("a glTF matrix is read column by column") {
  GltfText gltf;
  gltf.triangle();
  gltf.append("nodes", {{"mesh", 0}, {"matrix", {2, 0, 0, 0, 0, 3, 0, 0, 0, 0, 1, 0, 4, 5, 6, 1}}});
  const Scene scene = load(gltf);
  CHECK(corner(scene, 0, 0) == Vec3(4, 5, 6));
  CHECK(corner(scene, 0, 1) == Vec3(6, 5, 6));
  CHECK(corner(scene, 0, 2) == Vec3(4, 8, 6));
}

TEST_CASE("normals of stretched and mirrored glTF nodes stay perpendicular, on the front side") {
  for (const float x : {1.0f, -1.0f}) {
    CAPTURE(x);
    GltfText gltf;
    // A slope whose normal is not along an axis.
    const int positions = gltf.floats({0, 0, 0, 1, 0, -1, 0, 1, 0}, "VEC3", 3);
    const int normals = gltf.floats({kHalf, 0, kHalf, kHalf, 0, kHalf, kHalf, 0, kHalf}, "VEC3", 3);
    gltf.mesh({{"attributes", {{"POSITION", positions}, {"NORMAL", normals}}}});
    gltf.append("nodes", {{"mesh", 0}, {"scale", {x * 5, 2, 1}}});
    const Scene scene = load(gltf);
    REQUIRE(scene.triangles.size() == 1);
    const Vec3 normal = scene.normals[scene.triangles[0].normals[0]];
    checkNear(normal, faceNormal(scene, 0));
    CHECK(normal.x * x > 0);
    CHECK(normal.z > 0);
  }
}

TEST_CASE("EXT_mesh_gpu_instancing repeats a mesh within its node") {
  GltfText gltf;
  gltf.triangle();
  const int moved = gltf.floats({0, 0, 0, 0, 0, 7}, "VEC3", 3);
  const int scaled = gltf.floats({1, 1, 1, 2, 2, 2}, "VEC3", 3);
  gltf.append("nodes", {{"mesh", 0},
                        {"translation", {1, 0, 0}},
                        {"extensions",
                         {{"EXT_mesh_gpu_instancing",
                           {{"attributes", {{"TRANSLATION", moved}, {"SCALE", scaled}}}}}}}});
  const Scene scene = load(gltf);
  REQUIRE(scene.triangles.size() == 2);
  CHECK(corner(scene, 0, 1) == Vec3(2, 0, 0));
  CHECK(corner(scene, 1, 1) == Vec3(3, 0, 7));
}

TEST_CASE("more instances than the renderer holds are refused before they are written out") {
  GltfText gltf;
  std::vector<float> positions;
  for (int i = 0; i < 100; ++i) positions.insert(positions.end(), {0, 0, 0, 1, 0, 0, 0, 1, 0});
  gltf.mesh({{"attributes", {{"POSITION", gltf.floats(positions, "VEC3", 3)}}}});
  const int moved =
      gltf.append("accessors", {{"componentType", 5126}, {"count", 200000}, {"type", "VEC3"}});
  gltf.append(
      "nodes",
      {{"mesh", 0},
       {"extensions", {{"EXT_mesh_gpu_instancing", {{"attributes", {{"TRANSLATION", moved}}}}}}}});
  CHECK(refusal(gltf).find("more than 8,388,608") != std::string::npos);
}

TEST_CASE("the default glTF scene is shown, else the first, else all root nodes") {
  GltfText gltf;
  gltf.triangle();
  for (int i = 0; i < 3; ++i) gltf.append("nodes", {{"mesh", 0}, {"translation", {i, 0, 0}}});
  CHECK(load(gltf).triangles.size() == 3);
  gltf.root["scenes"] = {{{"nodes", {1}}}, {{"nodes", {0, 2}}}};
  Scene scene = load(gltf);
  REQUIRE(scene.triangles.size() == 1);
  CHECK(corner(scene, 0, 0).x == 1);
  gltf.root["scene"] = 1;
  CHECK(load(gltf).triangles.size() == 2);
  gltf.root["scene"] = 2;
  CHECK(refusal(gltf).find("default scene") != std::string::npos);
}

TEST_CASE("glTF nodes that do not form trees are refused") {
  const auto nodes = [](const Json& list) {
    GltfText gltf;
    gltf.triangle();
    gltf.root["nodes"] = list;
    return refusal(gltf);
  };
  CHECK(nodes({{{"children", {1}}}, {{"children", {0}}}}).find("ancestors") != std::string::npos);
  CHECK(nodes({{{"children", {0}}}}).find("ancestors") != std::string::npos);
  CHECK(nodes({{{"children", {2}}}, {{"children", {2}}}, {{"mesh", 0}}}).find("two parents") !=
        std::string::npos);
  CHECK(nodes({{{"children", {5}}}}).find("node 5") != std::string::npos);
  CHECK(nodes({{{"children", {-1}}}}).find("node -1") != std::string::npos);
  CHECK(nodes({{{"mesh", 1}}}).find("mesh 1") != std::string::npos);
  CHECK(nodes({{{"mesh", 0}, {"scale", {1e300, 1e300, 1}}, {"children", {1}}},
               {{"mesh", 0}, {"scale", {1e300, 1, 1}}}})
            .find("not finite") != std::string::npos);
  CHECK(nodes({{{"mesh", 0}, {"scale", {1, 2}}}}).find("2 numbers") != std::string::npos);
}

TEST_CASE("glTF nodes may nest deeper than a call stack") {
  GltfText gltf;
  gltf.triangle();
  constexpr int kDepth = 100000;
  Json nodes = Json::array();
  for (int i = 0; i < kDepth; ++i) nodes.push_back({{"children", {i + 1}}});
  nodes.push_back({{"mesh", 0}});
  gltf.root["nodes"] = nodes;
  CHECK(load(gltf).triangles.size() == 1);
}

TEST_CASE("a glTF far from its origin keeps its details, and its cameras their places") {
  GltfText gltf;
  gltf.triangle();
  gltf.root["cameras"] = {{{"type", "perspective"}, {"perspective", {{"yfov", 1}, {"znear", 1}}}}};
  gltf.append("nodes", {{"mesh", 0}, {"translation", {1e7, 0, 0}}});
  gltf.append("nodes", {{"camera", 0}, {"translation", {1e7 + 0.25, 0.25, 5}}});
  const Scene scene = load(gltf);
  REQUIRE(scene.triangles.size() == 1);
  CHECK(corner(scene, 0, 1) - corner(scene, 0, 0) == Vec3(1, 0, 0));
  const glm::dvec3 place = scene.origin + glm::dvec3(scene.camera.position);
  CHECK(place.x == Approx(1e7 + 0.25).epsilon(1e-12));
}
