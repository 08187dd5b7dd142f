// The demo scenes are what assets/README.md promises.
#include <catch2/catch.hpp>
#include <set>
#include <tuple>

#include "assets/generate/demos.h"
#include "renderer/scene/load_scene.h"
#include "tests/hostile/safe_scene.h"
#include "tests/unit/temporary_folder.h"

using namespace glimt;
namespace fs = std::filesystem;

namespace {

struct Promise {
  const char* name;
  std::size_t least_triangles, most_triangles;
  std::vector<std::string> variants;
};

const std::vector<Promise> kPromises = {
    {"christmas", 300'000, 500'000, {}},
    {"motorcycle",
     300'000,
     500'000,
     {"racing green", "signal red", "midnight blue", "matt black", "cream and orange"}},
    {"shop-motorcycle",
     300'000,
     500'000,
     {"racing green", "signal red", "midnight blue", "matt black", "cream and orange"}},
    {"watch",
     100'000,
     300'000,
     {"steel and navy canvas", "gold and brown leather", "black and orange",
      "bronze and olive canvas"}}};

std::set<std::string> filesIn(const fs::path& folder, const std::string& demo) {
  std::set<std::string> names;
  for (const auto& entry : fs::directory_iterator(folder))
    if (entry.path().filename().string().starts_with(demo))
      names.insert(entry.path().filename().string());
  return names;
}

std::tuple<float, float, float> colorOf(const Material& material) {
  return {material.base_color.x, material.base_color.y, material.base_color.z};
}

}  // namespace

TEST_CASE(
    "the demos have the triangles and variants that are promised, and load without a warning") {
  CHECK(assets::demos().size() == kPromises.size());
  for (const Promise& promise : kPromises) {
    CAPTURE(promise.name);
    const Scene scene =
        loadScene(fs::path(GLIMT_DEMOS_DIR) / (std::string(promise.name) + ".scene.json"));
    CHECK(flawOf(scene) == "");
    CHECK(scene.triangles.size() >= promise.least_triangles);
    CHECK(scene.triangles.size() <= promise.most_triangles);
    CHECK(scene.variants == promise.variants);
    CHECK(scene.warnings.empty());
  }
}

TEST_CASE("every variant of a demo has colours that no other one has") {
  for (const Promise& promise : kPromises) {
    const fs::path path = fs::path(GLIMT_DEMOS_DIR) / (std::string(promise.name) + ".scene.json");
    std::set<std::set<std::tuple<float, float, float>>> looks;
    for (const std::string& variant : promise.variants) {
      CAPTURE(promise.name, variant);
      const Scene scene = loadScene(path, {.variant = variant, .environment = {}});
      std::set<std::tuple<float, float, float>> colors;
      for (const Triangle& triangle : scene.triangles)
        colors.insert(colorOf(scene.materials[triangle.material]));
      CHECK(looks.insert(colors).second);
    }
  }
}

// The build has written them in another process.
TEST_CASE("a demo that is made again has the same bytes") {
  for (const auto& [name, make] : assets::demos()) {
    CAPTURE(name);
    const TemporaryFolder folder;
    assets::writeDemo(folder / "", make());
    const std::set<std::string> files = filesIn(folder / "", name);
    CHECK(files == filesIn(GLIMT_DEMOS_DIR, name));
    for (const std::string& file : files) {
      CAPTURE(file);
      const bool same = contentOf(folder / file) == contentOf(fs::path(GLIMT_DEMOS_DIR) / file);
      CHECK(same);
    }
  }
}
