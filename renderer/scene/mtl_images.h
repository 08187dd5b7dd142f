// The pictures that MTL materials name, as materials of the scene look them up.
#pragma once

#include <array>
#include <filesystem>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "renderer/scene/mtl_file.h"
#include "renderer/scene/scene.h"

namespace glimt {

// Reads each picture once into Scene::images.
class MtlImages {
 public:
  // The pictures are beside the model in `folder`. The scene outlives this.
  MtlImages(std::filesystem::path folder, Scene& scene);

  // MTL has a picture for each number, the scene one for several: those are put together.
  void addTo(Material& material, const MtlTextures& textures);

  // Tells in Scene::warnings what could not be read.
  void warn() const;

 private:
  // Where a channel comes from; without an image it is white.
  struct Source {
    std::uint32_t image = kNoIndex;
    std::size_t channel = 0;
  };

  // Into Scene::images; kNoIndex where there is none to read.
  std::uint32_t read(const std::string& file);
  std::uint32_t readInto(const std::string& file);
  bool hasRoomFor(const TextureImage& image) const;
  std::uint32_t combined(const std::array<Source, 4>& sources);
  void addBaseColor(Material& material, const MtlTextures& textures);
  void addMetallicRoughness(Material& material, const MtlTextures& textures);
  void addNormal(Material& material, const MtlTextures& textures);

  std::filesystem::path folder_;
  Scene* scene_;
  std::map<std::string, std::uint32_t> index_of_file_;
  std::map<std::vector<std::size_t>, std::uint32_t> index_of_sources_;
  std::set<std::string> missing_;
  std::set<std::string> unread_;  // with the reason
  std::set<std::string> heights_;
};

}  // namespace glimt
