#include "assets/generate/model/demo.h"

#include "assets/generate/model/gltf_writer.h"
#include "renderer/core/file.h"

namespace glimt::assets {

namespace {

using Json = nlohmann::ordered_json;

void writeJson(const std::filesystem::path& file, Json first, const Json& rest) {
  first.update(rest);
  writeFile(file, first.dump(2) + "\n");
}

}  // namespace

void writeDemo(const std::filesystem::path& folder, const Demo& demo) {
  writeGltf(folder, demo.name, demo.model);
  const std::string scene = demo.name + ".scene.json";
  writeJson(folder / scene, {{"model", demo.name + ".gltf"}}, demo.scene);
  if (!demo.batch.is_null())
    writeJson(folder / (demo.name + ".batch.json"), {{"scene", scene}}, demo.batch);
}

}  // namespace glimt::assets
