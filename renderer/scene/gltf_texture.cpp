#include "renderer/scene/gltf_texture.h"

#include <fmt/format.h>

#include <cmath>

#include "renderer/scene/gltf_extensions.h"

namespace glimt {
namespace {

Wrap wrapOf(int mode) {
  if (mode == TINYGLTF_TEXTURE_WRAP_CLAMP_TO_EDGE) return Wrap::clamp;
  return mode == TINYGLTF_TEXTURE_WRAP_MIRRORED_REPEAT ? Wrap::mirror : Wrap::repeat;
}

// The way a texture is seen from close by.
bool isNearest(const tinygltf::Sampler& sampler) {
  return sampler.magFilter == TINYGLTF_TEXTURE_FILTER_NEAREST;
}

void applySampler(const GltfDocument& document, int index, TextureUse& use) {
  if (index < 0) return;
  const auto& samplers = document.model.samplers;
  if (static_cast<std::size_t>(index) >= samplers.size())
    document.fail(
        fmt::format("a texture uses sampler {}, but the file has {}; export the model "
                    "again",
                    index, samplers.size()));
  const tinygltf::Sampler& sampler = samplers[static_cast<std::size_t>(index)];
  use.wrap_u = wrapOf(sampler.wrapS);
  use.wrap_v = wrapOf(sampler.wrapT);
  use.nearest = isNearest(sampler);
}

void applyTransform(const GltfDocument& document, const tinygltf::Value& transform,
                    TextureUse& use) {
  if (const auto offset = numbersOf(transform, "offset", 2); !offset.empty())
    use.offset = Vec2(offset[0], offset[1]);
  if (const auto scale = numbersOf(transform, "scale", 2); !scale.empty())
    use.scale = Vec2(scale[0], scale[1]);
  use.rotation = static_cast<float>(numberOf(transform, "rotation").value_or(0));
  use.texcoords = indexOf(transform, "texCoord").value_or(use.texcoords);
  const float sum = use.offset.x + use.offset.y + use.scale.x + use.scale.y + use.rotation;
  if (!std::isfinite(sum))
    document.fail("a KHR_texture_transform is not finite; export the model again");
}

}  // namespace

GltfTextureInfo textureInfoOf(const tinygltf::Value& object, const char* key,
                              tinygltf::ExtensionMap& extensions) {
  const tinygltf::Value* const member = memberOf(object, key);
  if (member == nullptr) return {};
  extensions.clear();
  if (const tinygltf::Value* const given = memberOf(*member, "extensions");
      given != nullptr && given->IsObject()) {
    for (const std::string& name : given->Keys()) extensions[name] = given->Get(name);
  }
  return {indexOf(*member, "index").value_or(-1), indexOf(*member, "texCoord").value_or(0),
          &extensions};
}

TextureUse textureUseOf(const GltfDocument& document, const GltfTextureInfo& info,
                        GltfImages& images, std::vector<std::string>& unshown,
                        const std::string& material) {
  if (info.index == -1) return {};
  const auto& textures = document.model.textures;
  if (info.index < 0 || static_cast<std::size_t>(info.index) >= textures.size())
    document.fail(
        fmt::format("material '{}' uses texture {}, but the file has {}; export the "
                    "model again",
                    material, info.index, textures.size()));
  const tinygltf::Texture& texture = textures[static_cast<std::size_t>(info.index)];
  TextureUse use;
  use.texcoords = info.texcoord;
  applySampler(document, texture.sampler, use);
  if (info.extensions != nullptr) {
    if (const auto* transform = extensionOf(*info.extensions, "KHR_texture_transform"))
      applyTransform(document, *transform, use);
  }
  const bool known_texcoords = use.texcoords == 0 || use.texcoords == 1;
  if (!known_texcoords || texture.source == -1) {
    unshown.push_back(material);
    return {};
  }
  use.image = images.load(texture.source);
  return use;
}

}  // namespace glimt
