// Which pictures a job is, what they are called, and what its manifest remembers.
#include <catch2/catch.hpp>

#include <set>

#include "app/batch/batch_estimate.h"
#include "app/batch/batch_plan.h"
#include "app/batch/contact_sheet.h"
#include "app/batch/manifest.h"
#include "renderer/core/sha256.h"
#include "renderer/scene/scene_digest.h"
#include "tests/unit/expect_error.h"
#include "tests/unit/temporary_folder.h"

using namespace glimt;

namespace {

Scene sceneWith(const std::vector<std::string>& variants, const std::vector<std::string>& cameras) {
  Scene scene;
  scene.variants = variants;
  for (const std::string& name : cameras) scene.cameras.push_back({name, Camera()});
  return scene;
}

std::set<std::string> stemsOf(const std::vector<BatchPicture>& plan) {
  std::set<std::string> stems;
  for (const BatchPicture& picture : plan) stems.insert(picture.stem);
  return stems;
}

BatchJob jobOf(const TemporaryFolder& folder, const std::string& text) {
  return readBatchJob(folder.write("job.json", text));
}

}  // namespace

TEST_CASE("SHA-256 is that of FIPS 180-2") {
  CHECK(sha256Of("abc") == "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
  CHECK(sha256Of("") == "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855");
}

TEST_CASE("a scene's digest changes with what its picture depends on, and with nothing else") {
  Scene scene;
  scene.materials.emplace_back();
  scene.positions = {Vec3(0), Vec3(1, 0, 0), Vec3(0, 1, 0)};
  const std::string before = digestOf(scene);
  Scene other = scene;
  other.name = "other";
  other.materials[0].name = "other";
  other.warnings.emplace_back("careful");
  CHECK(digestOf(other) == before);
  other.positions[1].x = 2;
  CHECK(digestOf(other) != before);
  other = scene;
  other.materials[0].normal_texture.nearest = true;
  CHECK(digestOf(other) != before);
  other = scene;
  other.camera.aperture_radius = 0.01f;
  CHECK(digestOf(other) != before);
}

TEST_CASE(
    "a job is a picture of each variant, in each view, in each size, and names tell them apart") {
  const TemporaryFolder folder;
  const BatchJob job = jobOf(folder, R"({"scene": "a shoe.scene.json", "variants": "all",
    "cameras": ["front/left"], "turntable": {"angles": 3, "start": -30},
    "sizes": [[4, 3], [8, 6]]})");
  const auto plan = planOf(job, sceneWith({"red", "deep blue"}, {"front/left"}));
  CHECK(plan.size() == 2 * (1 + 3) * 2);
  CHECK(stemsOf(plan).size() == plan.size());
  CHECK(stemsOf(plan).contains("deep-blue_front-left_8x6"));
  CHECK(stemsOf(plan).contains("red_330_4x3"));
  CHECK(job.folder == folder / "job");
}

TEST_CASE("a job without variants and views is one picture, called after the scene") {
  const TemporaryFolder folder;
  const auto plan = planOf(jobOf(folder, R"({"scene": "a shoe.scene.json"})"), sceneWith({}, {}));
  CHECK(stemsOf(plan) == std::set<std::string>{"a-shoe_512x512"});
}

TEST_CASE("names that files could not tell apart are an error, and so are those of no variant") {
  const TemporaryFolder folder;
  const BatchJob job = jobOf(folder, R"({"scene": "s.obj", "variants": ["a b", "a-b"]})");
  CHECK_THAT(messageOf(ErrorKind::input,
                       [&] {
                         planOf(job, sceneWith({"a b", "a-b"}, {}));
                       }),
             Catch::Contains("a-b_512x512"));
  CHECK_THAT(messageOf(ErrorKind::input, [&] { planOf(job, sceneWith({"a b"}, {})); }),
             Catch::Contains("no variant 'a-b'; it has 'a b'"));
}

TEST_CASE("a job file that is wrong is an error that names the key") {
  const TemporaryFolder folder;
  const auto [text, words] = GENERATE(table<std::string, std::string>({
      {R"({"spp": 3})", "\"scene\" is missing"},
      {R"({"scene": "s.obj", "samples": 3})", "unknown key \"samples\""},
      {R"({"scene": "s.obj", "sizes": [[0, 3]]})", "sizes must be"},
      {R"({"scene": "s.obj", "variants": []})", "variants must be"},
      {R"({"scene": "s.obj", "cameras": ["a", "a"]})", "cameras must be"},
      {R"({"scene": "s.obj", "turntable": {"angle": 3}})", "unknown key \"angle\" in turntable"},
      {R"({"scene": "s.obj", "noise": 0})", "noise must be percent"},
      {R"({"scene": "s.obj", "formats": ["jpg"]})", "formats must be"},
      {R"({"scene": "s.obj", "tone": "flat"})", "tone must be"},
  }));
  CHECK_THAT(messageOf(ErrorKind::input, [&] { jobOf(folder, text); }), Catch::Contains(words));
}

TEST_CASE("the parts of a job are the whole of it, and no picture is in two of them") {
  std::vector<BatchPicture> plan(10);
  for (std::size_t i = 0; i < plan.size(); ++i) plan[i].stem = std::to_string(i);
  const int parts = GENERATE(1, 3, 10, 13);
  std::vector<std::string> stems;
  for (int part = 1; part <= parts; ++part)
    for (const BatchPicture& picture : partOf(plan, part, parts)) stems.push_back(picture.stem);
  CHECK(stems.size() == 10);
  CHECK(std::set<std::string>(stems.begin(), stems.end()).size() == 10);
}

TEST_CASE("a turntable moves the camera around the vertical, counter-clockwise from above") {
  Camera camera;
  camera.position = Vec3(1, 3, 6);
  camera.target = Vec3(1, 1, 2);
  const Camera quarter = turned(camera, 90, {});
  CHECK(glm::distance(quarter.position, Vec3(5, 3, 2)) < 1e-5f);
  CHECK(quarter.target == camera.target);
  CHECK(glm::distance(turned(camera, 360, {}).position, camera.position) < 1e-5f);
  const Camera raised = turned(camera, 180, 30.0f);
  const float distance = glm::distance(camera.position, camera.target);
  CHECK(glm::distance(raised.position, raised.target) == Approx(distance));
  CHECK(raised.position.y == Approx(1 + 0.5f * distance));
  CHECK(raised.position.z < 2);
}

TEST_CASE("from straight above, an elevation brings the camera to the picture's lower edge") {
  Camera camera;
  camera.position = Vec3(0, 5, 0);
  camera.up = Vec3(0, 0, -1);
  const Camera level = turned(camera, 0, 0.0f);
  CHECK(glm::distance(level.position, Vec3(0, 0, 5)) < 1e-5f);
  CHECK(level.up == Vec3(0, 1, 0));
}

TEST_CASE("a manifest comes back as it was written, and parts of it as one") {
  const TemporaryFolder folder;
  Manifest first;
  first.add(ManifestEntry{"b.png", "red", "", 30.5, {4, 3}, 16, 0.25, 1.5, "cd", "ef"});
  first.add(ManifestFailure{"c.png", "no \"room\""});
  writeManifest(folder / manifestName(1, 1), first);
  Manifest second;
  second.add(ManifestEntry{"a.png", "", "front", {}, {8, 6}, 4, {}, 2, "12", "34"});
  writeManifest(folder / manifestName(2, 3), second);
  const Manifest read = readManifests(folder / "");
  REQUIRE(read.entries().size() == 2);
  CHECK(read.entries()[0].camera == "front");
  CHECK_FALSE(read.entries()[0].noise);
  const ManifestEntry* const entry = read.find("b.png");
  REQUIRE(entry != nullptr);
  CHECK(entry->angle == 30.5);
  CHECK(entry->noise == 0.25);
  CHECK(entry->size == std::array{4, 3});
  CHECK(entry->inputs == "ef");
  CHECK(read.find("c.png") == nullptr);
}

TEST_CASE("what is no manifest is an error that says what to do") {
  const TemporaryFolder folder;
  folder.write("manifest.json", R"({"pictures": [{"file": 3}]})");
  CHECK_THAT(messageOf(ErrorKind::input, [&] { readManifests(folder / ""); }),
             Catch::Contains("remove it"));
}

TEST_CASE("the time that is left follows from the pixels that are made") {
  BatchEstimate estimate;
  for (int i = 0; i < 4; ++i) estimate.plan({10, 10});
  CHECK_FALSE(estimate.secondsLeft({10, 10}, 1, {}));
  CHECK(estimate.secondsLeft({10, 10}, 1, 4.0).value() == Approx(4 + 3 * 5));
  estimate.done({10, 10}, 8);
  CHECK(estimate.secondsLeft({10, 10}, 2, {}).value() == Approx(3 * 8 - 2));
}

TEST_CASE("a contact sheet has a column for each variant and no other file in it") {
  const std::string page =
      contactSheet("shoes & more", {{"red", "30", "red_030.png", "8", "png"},
                                    {"<blue>", "30", "b_030.png", "8", "png"},
                                    {"red", "60", "red_060.png", "failed", ""}});
  CHECK_THAT(page, Catch::Contains("<th>red</th><th>&lt;blue&gt;</th>"));
  CHECK_THAT(page, Catch::Contains("shoes &amp; more"));
  CHECK_THAT(page, Catch::Contains("no picture"));
  CHECK_THAT(page, !Catch::Contains("src=\"red") && !Catch::Contains("http"));
}

TEST_CASE("a picture is reduced by means over its pixels") {
  Image image{3, 2, {}};
  for (int i = 0; i < 6; ++i) image.pixels.emplace_back(static_cast<float>(i));
  const Image small = reduced(image, 2);
  REQUIRE(small.width == 2);
  REQUIRE(small.height == 1);
  CHECK(small.pixels[0].x == Approx((0 + 1 + 3 + 4) / 4.0f));
  CHECK(small.pixels[1].x == Approx((2 + 5) / 2.0f));
}
