// The pictures of a glTF file, each decoded once, when a material first names it.
#pragma once

#include <cstdint>
#include <string>
#include <unordered_map>

#include "renderer/scene/gltf_document.h"
#include "renderer/scene/scene.h"

namespace glimt {

class GltfImages {
 public:
  // Puts what it decodes into `images`. Keeps references to both.
  GltfImages(const GltfDocument& document, std::vector<TextureImage>& images)
      : document_(document), images_(images) {}

  // The place in `images` of the file's picture of that index. Errors: input, for one that is not
  // there, is no PNG or JPEG, or is too large.
  std::uint32_t load(int image);

 private:
  std::string bytesOf(std::size_t image) const;

  const GltfDocument& document_;
  std::vector<TextureImage>& images_;
  std::unordered_map<std::size_t, std::uint32_t> loaded_;
  std::size_t pixels_ = 0;
};

}  // namespace glimt
