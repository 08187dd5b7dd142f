// How glTF files are stored, and what they may name.
#include <catch2/catch.hpp>

#include "renderer/scene/load_scene.h"
#include "tests/unit/expect_error.h"
#include "tests/unit/gltf_text.h"
#include "tests/unit/temporary_folder.h"

using namespace glimt;
using Json = GltfText::Json;

namespace {

GltfText oneTriangle() {
  GltfText gltf;
  gltf.triangle();
  gltf.append("nodes", {{"mesh", 0}});
  return gltf;
}

// With its buffer in a file of that URI.
std::string withBuffer(const GltfText& gltf, const std::string& uri) {
  Json root = gltf.root;
  root["buffers"] = {{{"byteLength", gltf.buffer().size()}, {"uri", uri}}};
  return root.dump();
}

std::string refusal(const std::string& text, const std::string& name = "model.gltf") {
  const TemporaryFolder folder;
  return messageOf(ErrorKind::input, [&] { loadScene(folder.write(name, text)); });
}

}  // namespace

TEST_CASE("a glTF is the same in one file, beside its buffer, as .glb and below a scene file") {
  const TemporaryFolder folder;
  const GltfText gltf = oneTriangle();
  folder.write("data/some buffer.bin", gltf.buffer());
  folder.write("in.glb", asGlb(gltf));
  for (const auto& path : {folder.write("one.gltf", gltf.text()),
                           folder.write("two.GLTF", withBuffer(gltf, "data/some%20buffer.bin")),
                           folder / "in.glb", folder.write("three.gltf", asGlb(gltf)),
                           folder.write("x.scene.json", R"({"model": "in.glb"})")}) {
    CAPTURE(path);
    const Scene scene = loadScene(path);
    REQUIRE(scene.triangles.size() == 1);
    CHECK(scene.positions.size() == 3);
  }
}

TEST_CASE("a glTF may name files in its own folder only") {
  const GltfText gltf = oneTriangle();
  for (const char* uri : {"../secret.bin", "/etc/passwd", "a/../../secret.bin", "%2e%2e/secret.bin",
                          "%2Fetc%2Fpasswd", "."}) {
    CAPTURE(uri);
    const std::string message = refusal(withBuffer(gltf, uri));
    CHECK(message.find("buffer 0") != std::string::npos);
  }
  CHECK(refusal(withBuffer(gltf, "../secret.bin")).find("outside") != std::string::npos);
  CHECK(refusal(withBuffer(gltf, "http://example.org/a.bin")).find("does not fetch") !=
        std::string::npos);
  CHECK(refusal(withBuffer(gltf, "file:///etc/passwd")).find("does not fetch") !=
        std::string::npos);
  CHECK(refusal(withBuffer(gltf, "not there.bin")).find("missing") != std::string::npos);
}

TEST_CASE("glTF buffers that are shorter than they say are refused") {
  GltfText gltf = oneTriangle();
  Json root = Json::parse(gltf.text());
  root["buffers"][0]["byteLength"] = 4000000000u;
  CHECK(refusal(root.dump()).find("buffer 0 says") != std::string::npos);
  root["buffers"][0].erase("byteLength");
  CHECK(refusal(root.dump()).find("byteLength") != std::string::npos);
}

TEST_CASE("damaged .glb files are refused for what is wrong with them") {
  const std::string good = asGlb(oneTriangle());
  CHECK(refusal(good.substr(0, 10), "a.glb").find("ends too early") != std::string::npos);
  CHECK(refusal(good.substr(0, good.size() - 1), "a.glb").find("says that it has") !=
        std::string::npos);
  std::string version = good;
  version[4] = 1;
  CHECK(refusal(version, "a.glb").find("version 1") != std::string::npos);
  std::string chunk = good;
  chunk[14] = 127;
  CHECK(refusal(chunk, "a.glb").find("longer than the file") != std::string::npos);
}

TEST_CASE("extensions that a glTF requires and glimt does not read are named") {
  GltfText gltf = oneTriangle();
  gltf.root["extensionsUsed"] = {"KHR_materials_unlit", "EXT_a", "EXT_b"};
  const TemporaryFolder folder;
  const Scene scene = loadScene(folder.write("model.gltf", gltf.text()));
  REQUIRE_FALSE(scene.warnings.empty());
  CHECK(scene.warnings[0].find("'EXT_a' and 'EXT_b'") != std::string::npos);
  gltf.root["extensionsRequired"] = {"EXT_b", "KHR_materials_unlit"};
  const std::string message = refusal(gltf.text());
  CHECK(message.find("'EXT_b'") != std::string::npos);
  CHECK(message.find("unlit") == std::string::npos);
}

TEST_CASE("what is no glTF 2.0, or would take all memory, is refused") {
  CHECK(refusal("{}").find("version ''") != std::string::npos);
  CHECK(refusal(R"({"asset": {"version": "1.0"}})").find("version '1.0'") != std::string::npos);
  CHECK(refusal("[1]").find("not an object") != std::string::npos);
  CHECK(refusal("{\"asset\": ").find("at byte") != std::string::npos);
  CHECK(refusal("").find("at byte") != std::string::npos);
  CHECK(refusal(R"({"asset": {"version": "2.0"}, "nodes": {}})").find("\"nodes\" must be") !=
        std::string::npos);
  const std::string deep(1000000, '[');
  CHECK(refusal(R"({"asset": {"version": "2.0"}, "x": )" + deep).find("deeper") !=
        std::string::npos);
  Json root = {{"asset", {{"version", "2.0"}}}};
  root["nodes"] = std::vector<Json>(300000, Json::object());
  CHECK(refusal(root.dump()).find("more than 262,144 nodes") != std::string::npos);
}
