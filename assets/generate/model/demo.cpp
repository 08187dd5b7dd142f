#include "assets/generate/model/demo.h"

#include "assets/generate/model/gltf_writer.h"
#include "renderer/core/file.h"

namespace glimt::assets {

void writeDemo(const std::filesystem::path& folder, const Demo& demo) {
  writeGltf(folder, demo.name, demo.model);
  nlohmann::ordered_json scene = {{"model", demo.name + ".gltf"}};
  scene.update(demo.scene);
  writeFile(folder / (demo.name + ".scene.json"), scene.dump(2) + "\n");
}

}  // namespace glimt::assets
