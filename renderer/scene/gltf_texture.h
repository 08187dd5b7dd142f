// How a glTF material looks up a picture: its texture, sampler and KHR_texture_transform.
#pragma once

#include <string>
#include <vector>

#include "renderer/scene/gltf_document.h"
#include "renderer/scene/gltf_image.h"
#include "renderer/scene/scene.h"

namespace glimt {

// What a material says of one of its textures.
struct GltfTextureInfo {
  int index = -1;  // into the model's textures; -1: none
  int texcoord = 0;
  const tinygltf::ExtensionMap* extensions = nullptr;  // may be null
};

// Of a member of an extension's object, as "clearcoatTexture".
GltfTextureInfo textureInfoOf(const tinygltf::Value& object, const char* key,
                              tinygltf::ExtensionMap& extensions);

// Loads the picture. A texture that glimt cannot show is left out, and `material` gets into
// `unshown`. Errors: input.
TextureUse textureUseOf(const GltfDocument& document, const GltfTextureInfo& info,
                        GltfImages& images, std::vector<std::string>& unshown,
                        const std::string& material);

}  // namespace glimt
