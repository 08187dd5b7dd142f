// Vertices and triangles of glTF files, in all the ways that they can be stored.
#include <catch2/catch.hpp>

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

// Of a file whose only mesh is in a node.
Scene loadMesh(GltfText& gltf) {
  gltf.append("nodes", {{"mesh", 0}});
  return load(gltf);
}

Vec3 corner(const Scene& scene, std::size_t triangle, std::size_t k) {
  return scene.positions[scene.triangles[triangle].positions[k]];
}

const std::vector<float> kSquare = {0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 1, 0};

Vec3 faceNormal(const Scene& scene, std::size_t triangle) {
  const Vec3 a = corner(scene, triangle, 0);
  return glm::normalize(glm::cross(corner(scene, triangle, 1) - a, corner(scene, triangle, 2) - a));
}

}  // namespace

TEST_CASE("glTF indices of every type, and none, give the same triangles") {
  for (const int type : {5121, 5123, 5125, 0}) {
    CAPTURE(type);
    GltfText gltf;
    const std::vector<float> positions =
        type == 0 ? std::vector<float>{0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0}
                  : kSquare;
    Json primitive = {{"attributes", {{"POSITION", gltf.floats(positions, "VEC3", 3)}}}};
    const std::vector<std::uint32_t> indices = {0, 1, 2, 1, 3, 2};
    if (type == 5121)
      primitive["indices"] = gltf.accessor(
          gltf.view(bytesOf(std::vector<std::uint8_t>(indices.begin(), indices.end()))), type, 6,
          "SCALAR");
    if (type == 5123)
      primitive["indices"] =
          gltf.shorts(std::vector<std::uint16_t>(indices.begin(), indices.end()));
    if (type == 5125)
      primitive["indices"] = gltf.accessor(gltf.view(bytesOf(indices)), type, 6, "SCALAR");
    gltf.mesh(primitive);
    const Scene scene = loadMesh(gltf);
    REQUIRE(scene.triangles.size() == 2);
    CHECK(corner(scene, 0, 1) == Vec3(1, 0, 0));
    CHECK(corner(scene, 1, 1) == Vec3(1, 1, 0));
  }
}

TEST_CASE("the triangles of glTF strips and fans all face the same way") {
  GltfText strip;
  strip.mesh({{"attributes", {{"POSITION", strip.floats(kSquare, "VEC3", 3)}}}, {"mode", 5}});
  GltfText fan;
  fan.mesh(
      {{"attributes", {{"POSITION", fan.floats({0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0}, "VEC3", 3)}}},
       {"mode", 6}});
  for (GltfText* gltf : {&strip, &fan}) {
    const Scene scene = loadMesh(*gltf);
    REQUIRE(scene.triangles.size() == 2);
    CHECK(faceNormal(scene, 0) == Vec3(0, 0, 1));
    CHECK(faceNormal(scene, 1) == Vec3(0, 0, 1));
  }
}

TEST_CASE("glTF points, lines and primitives without positions are dropped with a warning") {
  GltfText gltf;
  const int positions = gltf.floats(kSquare, "VEC3", 3);
  gltf.append("meshes", {{"primitives",
                          {{{"attributes", {{"POSITION", positions}}}, {"mode", 0}},
                           {{"attributes", {{"POSITION", positions}}}, {"mode", 3}},
                           {{"attributes", {{"NORMAL", positions}}}},
                           {{"attributes", {{"POSITION", positions}}}, {"mode", 5}}}}});
  const Scene scene = loadMesh(gltf);
  CHECK(scene.triangles.size() == 2);
  REQUIRE(scene.warnings.size() >= 2);
  CHECK(scene.warnings[0].find("2 primitives of points or lines") != std::string::npos);
  CHECK(scene.warnings[1].find("1 primitive without positions") != std::string::npos);
}

TEST_CASE("interleaved glTF attributes are read with their stride") {
  GltfText gltf;
  // Position, normal, colour; three vertices.
  const int view = gltf.view(bytesOf(std::vector<float>{0, 0, 0, 0, 0, 1, 1, 0, 0, 1, 0, 0, 0, 0,
                                                        1, 0, 1, 0, 0, 1, 0, 0, 0, 1, 0, 0, 1}),
                             36);
  Json attributes;
  int offset = 0;
  for (const char* name : {"POSITION", "NORMAL", "COLOR_0"}) {
    attributes[name] = gltf.accessor(view, 5126, 3, "VEC3");
    gltf.root["accessors"].back()["byteOffset"] = offset;
    offset += 12;
  }
  gltf.mesh({{"attributes", attributes}});
  const Scene scene = loadMesh(gltf);
  REQUIRE(scene.triangles.size() == 1);
  CHECK(corner(scene, 0, 2) == Vec3(0, 1, 0));
  CHECK(scene.triangles[0].smooth());
  CHECK(scene.normals[scene.triangles[0].normals[0]] == Vec3(0, 0, 1));
  REQUIRE(scene.triangles[0].colored());
  CHECK(scene.colors[scene.triangles[0].colors[1]] == Vec4(0, 1, 0, 1));
}

TEST_CASE("quantised glTF attributes mean what KHR_mesh_quantization says") {
  GltfText gltf;
  gltf.root["extensionsRequired"] = {"KHR_mesh_quantization"};
  // Padded to four bytes; -128 and -127 both are -1.
  const std::vector<std::int8_t> bytes = {-128, -127, 0, 0, 127, -127, 0, 0, 0, 127, 0, 0};
  const std::vector<std::uint16_t> texcoords = {0, 65535, 32768, 0, 3, 7};
  const int positions = gltf.accessor(gltf.view(bytesOf(bytes), 4), 5120, 3, "VEC3");
  gltf.root["accessors"].back()["normalized"] = true;
  const int normalized = gltf.accessor(gltf.view(bytesOf(texcoords)), 5123, 3, "VEC2");
  gltf.root["accessors"].back()["normalized"] = true;
  const int whole = gltf.accessor(gltf.view(bytesOf(texcoords)), 5123, 3, "VEC2");
  gltf.mesh({{"attributes",
              {{"POSITION", positions}, {"TEXCOORD_0", normalized}, {"TEXCOORD_1", whole}}}});
  const Scene scene = loadMesh(gltf);
  REQUIRE(scene.triangles.size() == 1);
  CHECK(corner(scene, 0, 0) == Vec3(-1, -1, 0));
  CHECK(corner(scene, 0, 1) == Vec3(1, -1, 0));
  REQUIRE(scene.triangles[0].textured());
  const auto sets = [&](std::size_t k) {
    return scene.texcoords[scene.triangles[0].texcoords[k]].sets;
  };
  CHECK(sets(0)[0] == Vec2(0, 1));
  CHECK(sets(1)[0].x == Approx(32768.0 / 65535));
  CHECK(sets(2)[1] == Vec2(3, 7));
}

TEST_CASE("sparse glTF accessors replace elements, also of zeros") {
  for (const bool has_view : {true, false}) {
    CAPTURE(has_view);
    GltfText gltf;
    const int indices = gltf.view(bytesOf(std::vector<std::uint16_t>{1, 2}));
    const int values = gltf.view(bytesOf(std::vector<float>{5, 0, 0, 0, 6, 0}));
    Json accessor = {{"componentType", 5126}, {"count", 3}, {"type", "VEC3"}};
    accessor["sparse"] = {{"count", 2},
                          {"indices", {{"bufferView", indices}, {"componentType", 5123}}},
                          {"values", {{"bufferView", values}}}};
    if (has_view)
      accessor["bufferView"] = gltf.view(bytesOf(std::vector<float>{0, 0, 0, 1, 0, 0, 0, 1, 0}));
    const int positions = gltf.append("accessors", accessor);
    gltf.mesh({{"attributes", {{"POSITION", positions}}}});
    const Scene scene = loadMesh(gltf);
    REQUIRE(scene.triangles.size() == 1);
    CHECK(corner(scene, 0, 0) == Vec3(0));
    CHECK(corner(scene, 0, 1) == Vec3(5, 0, 0));
    CHECK(corner(scene, 0, 2) == Vec3(0, 6, 0));
  }
}

TEST_CASE("glTF accessors that reach beyond what is there are refused before they are read") {
  const auto refusal = [](const Json& change, int accessor) {
    GltfText gltf;
    const int positions = gltf.floats(kSquare, "VEC3", 3);
    const int indices = gltf.shorts({0, 1, 2});
    gltf.mesh({{"attributes", {{"POSITION", positions}}}, {"indices", indices}});
    gltf.root["accessors"][accessor].update(change);
    return messageOf(ErrorKind::input, [&] { loadMesh(gltf); });
  };
  CHECK(refusal({{"count", 5}}, 0).find("POSITION") != std::string::npos);
  CHECK(refusal({{"count", 4000000000u}}, 0).find("at most") != std::string::npos);
  CHECK(refusal({{"count", 18446744073709551615u}}, 0).find("at most") != std::string::npos);
  CHECK(refusal({{"count", 0}}, 0).find("no elements") != std::string::npos);
  CHECK(refusal({{"byteOffset", 4}}, 0).find("beyond") != std::string::npos);
  CHECK(refusal({{"byteOffset", 18446744073709551612u}}, 0).find("beyond") != std::string::npos);
  CHECK(refusal({{"bufferView", 9}}, 0).find("buffer view 9") != std::string::npos);
  CHECK(refusal({{"type", "MAT4"}}, 0).find("type") != std::string::npos);
  CHECK(refusal({{"type", "VEC2"}}, 0).find("components") != std::string::npos);
  CHECK(refusal({{"componentType", 5126}}, 1).find("unsigned integers") != std::string::npos);
  CHECK(refusal({{"componentType", 5130}}, 0).find("type") != std::string::npos);
}

TEST_CASE("glTF buffer views and indices out of range are refused") {
  const auto square = [](const std::vector<std::uint16_t>& indices) {
    GltfText gltf;
    const int positions = gltf.floats(kSquare, "VEC3", 3);
    gltf.mesh({{"attributes", {{"POSITION", positions}}}, {"indices", gltf.shorts(indices)}});
    return gltf;
  };
  const auto refusal = [](GltfText gltf) {
    return messageOf(ErrorKind::input, [&] { loadMesh(gltf); });
  };
  CHECK(refusal(square({0, 1, 4})).find("vertex 4") != std::string::npos);
  GltfText beyond = square({0, 1, 2});
  beyond.root["bufferViews"][0]["byteLength"] = 18446744073709551615u;
  CHECK(refusal(beyond).find("beyond its buffer") != std::string::npos);
  GltfText narrow = square({0, 1, 2});
  narrow.root["bufferViews"][0]["byteStride"] = 4;
  CHECK(refusal(narrow).find("overlap") != std::string::npos);
  GltfText unequal = square({0, 1, 2});
  unequal.root["meshes"][0]["primitives"][0]["attributes"]["NORMAL"] =
      unequal.floats({0, 0, 1}, "VEC3", 3);
  CHECK(refusal(unequal).find("another attribute") != std::string::npos);
}
