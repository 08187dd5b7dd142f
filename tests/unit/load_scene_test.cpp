// OBJ and MTL, and what every scene gets: camera, light, checks.
#include "renderer/scene/load_scene.h"

#include <cmath>

#include "renderer/scene/effects_of.h"
#include "tests/unit/expect_error.h"
#include "tests/unit/temporary_folder.h"

using namespace glimt;
namespace fs = std::filesystem;

namespace {

const std::string kTriangle = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";

bool warns(const Scene& scene, const std::string& about) {
  for (const std::string& warning : scene.warnings) {
    CHECK(warning.find('\n') == std::string::npos);
    if (warning.find(about) != std::string::npos) return true;
  }
  return false;
}

Scene loadObj(const std::string& text) {
  const TemporaryFolder folder;
  return loadScene(folder.write("model.obj", text));
}

Scene loadObj(const std::string& text, const std::string& mtl) {
  const TemporaryFolder folder;
  folder.write("model.mtl", mtl);
  return loadScene(folder.write("model.obj", "mtllib model.mtl\n" + text));
}

std::string objError(const std::string& text) {
  return messageOf(ErrorKind::input, [&] { loadObj(text); });
}

const Material& materialOf(const Scene& scene, std::size_t triangle) {
  return scene.materials.at(scene.triangles.at(triangle).material);
}

}  // namespace

TEST_CASE("a triangle without anything else is grey, flat and named after its file") {
  const Scene scene = loadObj(kTriangle);
  CHECK(scene.name == "model");
  CHECK(scene.positions.size() == 3);
  REQUIRE(scene.triangles.size() == 1);
  CHECK_FALSE(scene.triangles[0].smooth());
  CHECK(materialOf(scene, 0).base_color == Vec3(0.8f));
  CHECK(materialOf(scene, 0).double_sided);
  CHECK_FALSE(scene.render.size.has_value());
}

TEST_CASE("the winding and the corners of faces are kept") {
  const Scene scene = loadObj("v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 2 3 4 1\n");
  REQUIRE(scene.triangles.size() == 2);
  for (const Triangle& t : scene.triangles) {
    const Vec3 a = scene.positions[t.positions[0]];
    const Vec3 normal =
        glm::cross(scene.positions[t.positions[1]] - a, scene.positions[t.positions[2]] - a);
    CHECK(normal == Vec3(0, 0, 1));
  }
}

TEST_CASE("negative indices count back from where they stand") {
  const Scene scene =
      loadObj("v 9 9 9\n" + std::string("v 0 0 0\nv 1 0 0\nv 0 1 0\nf -3 -2 -1\n") + "v 5 5 5\n");
  REQUIRE(scene.triangles.size() == 1);
  CHECK(scene.positions[scene.triangles[0].positions[0]] == Vec3(0));
  CHECK(scene.positions.size() == 3);
}

TEST_CASE("normals make a face smooth, get unit length and need no texture coordinates") {
  const Scene scene = loadObj(
      "v 0 0 0\nv 1 0 0\nv 0 1 0\nvn 0 0 5\nvn 0 3 4\nvt 0 0\n"
      "f 1//1 2//2 3//-1\nf 1/1/1 2/1/1 3/1/1\nf 1/1 2/1 3/1\n");
  REQUIRE(scene.triangles.size() == 3);
  CHECK(scene.triangles[0].smooth());
  CHECK(scene.triangles[1].smooth());
  CHECK_FALSE(scene.triangles[2].smooth());
  CHECK(scene.normals[scene.triangles[0].normals[0]] == Vec3(0, 0, 1));
  CHECK(scene.normals[scene.triangles[0].normals[1]] == Vec3(0, 0.6f, 0.8f));
}

TEST_CASE("lines end as on any system, and one that ends in a backslash goes on in the next") {
  for (const std::string end : {"\n", "\r\n", "\r"}) {
    std::string text =
        "\xef\xbb\xbfv 0 0 0 # first\n\nv 1 0 \\\n 0\nv\t0 1 0 \n  f 1 2 \\\n3 # face";
    for (std::size_t at = 0; (at = text.find('\n', at)) != std::string::npos; at += end.size()) {
      text.replace(at, 1, end);
    }
    const Scene scene = loadObj(text);
    CHECK(scene.triangles.size() == 1);
    CHECK(scene.positions[1] == Vec3(1, 0, 0));
  }
}

TEST_CASE("numbers are read with points, exponents and signs, and in any locale") {
  const Scene scene = loadObj("v +1.5e1 -.25 1E-2\nv 0.1 3.14159265 1e3\nv 1. 0 0\nf 1 2 3\n");
  CHECK(scene.positions[0] == Vec3(15.0f, -0.25f, 0.01f));
  CHECK(scene.positions[1] == Vec3(0.1f, 3.14159265f, 1000.0f));
}

TEST_CASE("triangles with vertices that are no finite numbers are dropped with a warning") {
  const Scene scene = loadObj(
      "v 0 0 0\nv 1 0 0\nv 0 1 0\nv nan 0 0\nv 0 -inf 0\nv 1e999 0 0\nv 1.#IND 0 0\nv 1,5 0 0\n"
      "f 1 2 3\nf 1 2 4\nf 1 2 5\nf 1 2 6\nf 1 2 7\nf 1 2 8\n");
  CHECK(scene.triangles.size() == 1);
  CHECK(scene.positions.size() == 3);
  CHECK(warns(scene, "dropped 5 triangles with a vertex that is not a finite number"));
}

TEST_CASE("triangles without an area are dropped with a warning, tiny ones are kept") {
  const Scene scene = loadObj(
      "v 0 0 0\nv 1 0 0\nv 2 0 0\nv 1e-8 0 0\nv 0 1e-8 0\nf 1 2 3\nf 1 2 2\nf 1 1 1\nf 1 4 5\n");
  CHECK(scene.triangles.size() == 1);
  CHECK(warns(scene, "dropped 3 triangles without an area"));
}

TEST_CASE("triangles beyond any reasonable distance are dropped with a warning") {
  const Scene scene = loadObj(kTriangle + "v 1e30 0 0\nf 1 3 4\n");
  CHECK(scene.triangles.size() == 1);
  CHECK(warns(scene, "dropped 1 triangle with a vertex farther than"));
}

TEST_CASE("a model far from the file's origin is moved to its own, and keeps its shape") {
  const Scene scene = loadObj(
      "v 5e8 -2000000.75 0\nv 500000001 -2000000.75 0\nv 500000000 -1999999.65 0.1\nf 1 2 3\n"
      "v 0 0 0\n");
  CHECK(glm::distance(scene.origin, glm::dvec3(500000000.5, -2000000.2, 0.05)) < 1e-6);
  CHECK(scene.positions[1] - scene.positions[0] == Vec3(1, 0, 0));
  CHECK((scene.positions[2] - scene.positions[0]).y == Approx(1.1));
  CHECK(glm::length(scene.camera.target) < 1e-6f);
  CHECK(scene.warnings.size() == 1);  // of the light
}

TEST_CASE("a model that is some sizes from the file's origin stays where it is") {
  const Scene scene = loadObj("v 10.1 0 0\nv 11 0 0\nv 10.1 1 0\nf 1 2 3\n");
  CHECK(scene.origin == glm::dvec3(0));
  CHECK(scene.positions[0] == Vec3(10.1f, 0, 0));
}

TEST_CASE("one vertex that is far off does not move the model") {
  CHECK(loadObj(kTriangle + "v 1e30 0 0\nf 1 3 4\n").origin == glm::dvec3(0));
  CHECK(loadObj(kTriangle + "v inf 0 0\nf 1 3 4\n").origin == glm::dvec3(0));
}

TEST_CASE("a model of which nothing is left is an empty scene with a warning") {
  const Scene scene = loadObj("v 0 0 0\nf 1 1 1\n");
  CHECK(scene.triangles.empty());
  CHECK(scene.positions.empty());
  CHECK(warns(scene, "no triangle is left"));
  CHECK(std::isfinite(scene.camera.position.z));
}

TEST_CASE("normals that are zero, not finite or not there make their triangle flat") {
  const Scene scene = loadObj(
      "v 0 0 0\nv 1 0 0\nv 0 1 0\nvn 0 0 0\nvn nan 0 0\nvn 0 0 1\n"
      "f 1//3 2//3 3//1\nf 1//3 2//3 3//2\nf 1//3 2//3 3\nf 1//3 2//3 3//9\nf 1//3 2//3 3//3\n");
  REQUIRE(scene.triangles.size() == 5);
  for (std::size_t i = 0; i < 4; ++i) CHECK_FALSE(scene.triangles[i].smooth());
  CHECK(scene.triangles[4].smooth());
  CHECK(scene.normals.size() == 1);
  CHECK(warns(scene, "shaded 3 triangles flat"));
  CHECK(warns(scene, "shaded 1 face flat: a normal that the file does not have"));
}

TEST_CASE("faces that name vertices that are not there are errors with their line") {
  CHECK_THAT(objError(kTriangle + "\nf 1 2 9\n"),
             Catch::Contains(".obj:6: ") && Catch::Contains("vertex 9, but the file has 3"));
  CHECK_THAT(objError("f 0 1 2\n" + kTriangle), Catch::Contains(".obj:1: "));
  CHECK_THAT(objError(kTriangle + "f -1 -2 -4\n"), Catch::Contains("vertex -4, but only 3"));
  CHECK_THAT(objError(kTriangle + "f a b c\n"), Catch::Contains(".obj:5: "));
  CHECK_THAT(objError(kTriangle + "f 1 2 2147483647\n"), Catch::Contains("vertex 2147483647"));
}

TEST_CASE("vertices may follow the faces that use them") {
  CHECK(loadObj("f 1 2 3\nv 0 0 0\nv 1 0 0\nv 0 1 0\n").triangles.size() == 1);
}

TEST_CASE("vertices of less than three numbers are errors with their line") {
  CHECK_THAT(objError("v 0 0 0\nv 1 0\n"), Catch::Contains(".obj:2: a vertex needs three numbers"));
}

TEST_CASE("files without faces are errors: empty, vertices alone, other text, binary, UTF-16") {
  CHECK_THAT(objError(""), Catch::Contains("has no faces"));
  CHECK_THAT(objError("v 0 0 0\nl 1 1\np 1\n"), Catch::Contains("has no faces"));
  CHECK_THAT(objError("%PDF-1.4\nnothing\n"), Catch::Contains("has no faces"));
  CHECK_THAT(objError(std::string("v 0 0 0\n\0\0\x01", 11)),
             Catch::Contains(":2: not a text file"));
  CHECK_THAT(objError("\xff\xfev\0 \0"), Catch::Contains("UTF-16"));
}

TEST_CASE("faces of less than three corners are left out with a warning") {
  const Scene scene = loadObj(kTriangle + "f 1 2\nf 3\n");
  CHECK(scene.triangles.size() == 1);
  CHECK(warns(scene, "dropped 2 faces of less than three corners"));
}

TEST_CASE("missing files, folders and unknown kinds of file are errors that say what to do") {
  const TemporaryFolder folder;
  fs::create_directory(folder / "folder.obj");
  const auto error = [&](const std::string& name) {
    const std::string message = messageOf(ErrorKind::input, [&] { loadScene(folder / name); });
    CHECK_THAT(message, Catch::StartsWith((folder / name).string() + ": "));
    return message;
  };
  CHECK_THAT(error("none.obj"), Catch::Contains("no such file"));
  CHECK_THAT(error("none.scene.json"), Catch::Contains("no such file"));
  CHECK_THAT(error("none.stl"), Catch::Contains("no such file"));
  CHECK_THAT(error("folder.obj"), Catch::Contains("it is a folder"));
  folder.write("model.stl", kTriangle);
  CHECK_THAT(error("model.stl"), Catch::Contains("glimt reads .obj"));
}

TEST_CASE("names in UTF-8 and with blanks work, for models and for material files") {
  const TemporaryFolder folder;
  folder.write("m\xc3\xb8 del \xe2\x99\xbb/bl\xc3\xa5 ting.mtl",
               "newmtl bl\xc3\xa5 lak\nKd 0 0 1\n");
  const fs::path path =
      folder.write("m\xc3\xb8 del \xe2\x99\xbb/min model.OBJ",
                   "mtllib bl\xc3\xa5 ting.mtl\nusemtl  bl\xc3\xa5 lak \n" + kTriangle);
  const Scene scene = loadScene(path);
  CHECK(scene.name == "min model");
  CHECK(materialOf(scene, 0).name == "bl\xc3\xa5 lak");
  CHECK(materialOf(scene, 0).base_color == Vec3(0, 0, 1));
}

TEST_CASE("Kd becomes the base colour and Ke the emission, seen from both sides") {
  const Scene scene =
      loadObj("usemtl light\n" + kTriangle, "newmtl light\nKd 0.1 0.2 0.3\nKe 17 12 4\nillum 1\n");
  CHECK(materialOf(scene, 0).base_color == Vec3(0.1f, 0.2f, 0.3f));
  CHECK(materialOf(scene, 0).emission == Vec3(17, 12, 4));
  CHECK(materialOf(scene, 0).double_sided);
  CHECK(scene.warnings.empty());
}

TEST_CASE("a material that gives no Kd is grey, not black") {
  const Scene scene = loadObj("usemtl b\n" + kTriangle, "newmtl a\nKd 1 0 0\nnewmtl b\nNs 10\n");
  CHECK(materialOf(scene, 0).base_color == Vec3(0.8f));
}

TEST_CASE("colours that no surface can have are clamped with a warning") {
  const Scene scene =
      loadObj("usemtl a\n" + kTriangle, "newmtl a\nKd 2 -1 0.5\nKe -3 1e999 2\nillum 0\n");
  CHECK(materialOf(scene, 0).base_color == Vec3(1, 0, 0.5f));
  CHECK(materialOf(scene, 0).emission == Vec3(0, 0, 2));
  CHECK(warns(scene, "base colour brought into 0 to 1: 'a'"));
  CHECK(warns(scene, "emission that is negative or not finite became 0: 'a'"));
}

TEST_CASE("textures are warned about once, and only of materials in use") {
  const Scene scene = loadObj("usemtl a\n" + kTriangle + "usemtl b\nf 1 2 3\nusemtl a\nf 3 2 1\n",
                              "newmtl a\nKs 1 1 1\nillum 5\nmap_Kd x.png\nmap_Ks s.png\nnewmtl b\n"
                              "d 0.5\nillum 7\nnewmtl unused\nPm 1\nmap_Kd y.png\n");
  CHECK(scene.triangles.size() == 3);
  CHECK(warns(scene, "no place in the material, of 'a'"));
  CHECK(warns(scene, "no picture 'x.png' beside the model"));
  CHECK_FALSE(warns(scene, "y.png"));
  CHECK_FALSE(warns(scene, "unused"));
}

TEST_CASE("a missing material file, or a name that none defines, gives grey and a warning") {
  const Scene scene = loadObj("mtllib none.mtl\nusemtl red\n" + kTriangle);
  CHECK(warns(scene, "no material file 'none.mtl'"));
  CHECK(warns(scene, "no material file defines 'red'"));
  CHECK(materialOf(scene, 0).name == "red");
  CHECK(materialOf(scene, 0).base_color == Vec3(0.8f));
}

TEST_CASE("a material file that cannot be read is a warning") {
  const TemporaryFolder folder;
  folder.write("binary.mtl", std::string("newmtl \0", 8));
  const Scene scene =
      loadScene(folder.write("model.obj", "mtllib binary.mtl\nmtllib /dev/zero\n" + kTriangle));
  CHECK(scene.triangles.size() == 1);
  CHECK(warns(scene, "binary.mtl:1: not a text file"));
  CHECK(warns(scene, "/dev/zero: cannot read"));
}

TEST_CASE("mtllib finds several files, either slash, escaped blanks and files that moved") {
  const TemporaryFolder folder;
  folder.write("a.mtl", "newmtl a\nKd 1 0 0\n");
  folder.write("b c.mtl", "newmtl b\nKd 0 1 0\n");
  folder.write("sub/d.mtl", "newmtl d\nKd 0 0 1\n");
  folder.write("e.mtl", "newmtl e\nKd 1 1 0\n");
  const Scene scene = loadScene(folder.write(
      "model.obj",
      "mtllib a.mtl b\\ c.mtl\nmtllib .\\sub\\d.mtl\nmtllib somewhere/else/e.mtl\n" + kTriangle +
          "usemtl a\nf 1 2 3\nusemtl b\nf 1 2 3\nusemtl d\nf 1 2 3\nusemtl e\nf 1 2 3\n"));
  CHECK(materialOf(scene, 1).base_color == Vec3(1, 0, 0));
  CHECK(materialOf(scene, 2).base_color == Vec3(0, 1, 0));
  CHECK(materialOf(scene, 3).base_color == Vec3(0, 0, 1));
  CHECK(materialOf(scene, 4).base_color == Vec3(1, 1, 0));
}

TEST_CASE("an OBJ without light gets a studio and a warning, one with light stays dark") {
  const Scene dark = loadObj(kTriangle);
  CHECK(dark.environment.image.width == 512);
  CHECK(warns(dark, "nothing gives light, so a studio does"));
  const Scene lit = loadObj("usemtl a\n" + kTriangle, "newmtl a\nKe 1 1 1\n");
  CHECK(lit.environment.radiance() == Vec3(0));
  CHECK(effectsOf(lit) == EffectSet(1));
  const Scene unused = loadObj(kTriangle, "newmtl a\nKe 1 1 1\n");
  CHECK(unused.environment.shines());
}

TEST_CASE("without a camera the model is seen from the front, centred and filling the picture") {
  const Scene scene = loadObj(
      "v 10 0 -5\nv 14 0 -5\nv 14 2 -5\nv 10 2 -5\nf 1 2 3 4\nv 10 0 -9\nv 14 0 -9\nv 14 2 -9\n"
      "f 5 6 7\n");
  CHECK(scene.camera.target == Vec3(12, 1, -7));
  CHECK(scene.camera.position.x == 12);
  CHECK(scene.camera.position.y == 1);
  const float half_width =
      (scene.camera.position.z + 5) * std::tan(glm::radians(0.5f * scene.camera.vertical_fov));
  CHECK(half_width > 2.0f);
  CHECK(half_width < 2.2f);
}
