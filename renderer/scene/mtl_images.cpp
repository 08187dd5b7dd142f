#include "renderer/scene/mtl_images.h"

#include <fmt/format.h>

#include <algorithm>

#include "renderer/core/error.h"
#include "renderer/core/wording.h"
#include "renderer/scene/path_beside.h"
#include "renderer/scene/texture_image.h"

namespace glimt {
namespace {

// Of all pictures together: as many as the renderer has room for.
constexpr std::size_t kMostBytes = std::size_t{1} << 30;
constexpr std::size_t kMostImages = 4096;

std::size_t bytesOf(const Scene& scene) {
  std::size_t bytes = 0;
  for (const TextureImage& image : scene.images) bytes += image.rgba.size();
  return bytes;
}

bool hasAlpha(const TextureImage& image) {
  for (std::size_t i = 3; i < image.rgba.size(); i += 4)
    if (image.rgba[i] != 255) return true;
  return false;
}

// Normals point out of the surface, so their map is blue; a map of heights is grey.
bool holdsNormals(const TextureImage& image) {
  double red = 0;
  double blue = 0;
  for (std::size_t i = 0; i < image.rgba.size(); i += 4) {
    red += image.rgba[i];
    blue += image.rgba[i + 2];
  }
  return blue > 1.2 * red;
}

}  // namespace

MtlImages::MtlImages(std::filesystem::path folder, Scene& scene)
    : folder_(std::move(folder)), scene_(&scene) {}

std::uint32_t MtlImages::read(const std::string& file) {
  if (file.empty()) return kNoIndex;
  const auto found = index_of_file_.find(file);
  if (found != index_of_file_.end()) return found->second;
  const std::uint32_t index = readInto(file);
  index_of_file_.emplace(file, index);
  return index;
}

bool MtlImages::hasRoomFor(const TextureImage& image) const {
  return bytesOf(*scene_) + image.rgba.size() <= kMostBytes && scene_->images.size() < kMostImages;
}

std::uint32_t MtlImages::readInto(const std::string& file) {
  const std::filesystem::path path = pathBeside(folder_, file);
  if (path.empty()) {
    missing_.insert(file);
    return kNoIndex;
  }
  try {
    TextureImage image = readTextureImage(path);
    if (!hasRoomFor(image))
      throw Error(ErrorKind::input, fmt::format("{}: the model has more pictures than there is "
                                                "room for; use smaller ones",
                                                printable(path.string())));
    scene_->images.push_back(std::move(image));
  } catch (const Error& error) {
    unread_.insert(error.what());
    return kNoIndex;
  }
  return static_cast<std::uint32_t>(scene_->images.size() - 1);
}

// A picture of its own, as large as the first source; the others are sampled at its pixels.
std::uint32_t MtlImages::combined(const std::array<Source, 4>& sources) {
  std::vector<std::size_t> key;
  for (const Source& source : sources) key.insert(key.end(), {source.image, source.channel});
  const auto found = index_of_sources_.find(key);
  if (found != index_of_sources_.end()) return found->second;
  const auto first = std::find_if(sources.begin(), sources.end(),
                                  [](const Source& source) { return source.image != kNoIndex; });
  if (first == sources.end()) return kNoIndex;
  if (!hasRoomFor(scene_->images[first->image])) {
    unread_.insert(fmt::format("{}: the model has more pictures than there is room for",
                               scene_->images[first->image].name));
    return kNoIndex;
  }
  TextureImage image = scene_->images[first->image];
  for (int y = 0; y < image.height; ++y)
    for (int x = 0; x < image.width; ++x)
      for (std::size_t channel = 0; channel < 4; ++channel) {
        const auto at = static_cast<std::size_t>(y) * static_cast<std::size_t>(image.width) +
                        static_cast<std::size_t>(x);
        std::uint8_t value = 255;
        if (sources[channel].image != kNoIndex) {
          const TextureImage& from = scene_->images[sources[channel].image];
          const auto column = static_cast<std::size_t>(std::int64_t{x} * from.width / image.width);
          const auto row = static_cast<std::size_t>(std::int64_t{y} * from.height / image.height);
          value = from.rgba[4 * (row * static_cast<std::size_t>(from.width) + column) +
                            sources[channel].channel];
        }
        image.rgba[4 * at + channel] = value;
      }
  scene_->images.push_back(std::move(image));
  const auto index = static_cast<std::uint32_t>(scene_->images.size() - 1);
  index_of_sources_.emplace(key, index);
  return index;
}

// The picture of alpha may be one with an alpha channel, or a grey one.
void MtlImages::addBaseColor(Material& material, const MtlTextures& textures) {
  const std::uint32_t color = read(textures.base_color.file);
  const std::uint32_t alpha = read(textures.alpha.file);
  TextureUse& use = material.base_color_texture;
  use = color != kNoIndex ? textures.base_color.use : textures.alpha.use;
  use.image = color;
  if (alpha == kNoIndex) return;
  material.alpha_mode = AlphaMode::blend;
  const std::size_t channel = hasAlpha(scene_->images[alpha]) ? 3 : 0;
  if (color == alpha && channel == 3) return;
  use.image = combined({{{color, 0}, {color, 1}, {color, 2}, {alpha, channel}}});
}

void MtlImages::addMetallicRoughness(Material& material, const MtlTextures& textures) {
  const std::uint32_t roughness = read(textures.roughness.file);
  const std::uint32_t metallic = read(textures.metallic.file);
  if (roughness == kNoIndex && metallic == kNoIndex) return;
  TextureUse& use = material.metallic_roughness_texture;
  use = roughness != kNoIndex ? textures.roughness.use : textures.metallic.use;
  use.image = combined({{{}, {roughness, 1}, {metallic, 2}, {}}});
  if (roughness != kNoIndex && material.roughness == 0) material.roughness = 1;
  if (metallic != kNoIndex && material.metallic == 0) material.metallic = 1;
}

void MtlImages::addNormal(Material& material, const MtlTextures& textures) {
  const std::uint32_t normal = read(textures.normal.file);
  if (normal == kNoIndex) return;
  if (textures.normal_may_be_heights && !holdsNormals(scene_->images[normal])) {
    heights_.insert(textures.normal.file);
    return;
  }
  material.normal_texture = textures.normal.use;
  material.normal_texture.image = normal;
  material.normal_scale = textures.normal_scale;
}

void MtlImages::addTo(Material& material, const MtlTextures& textures) {
  addBaseColor(material, textures);
  addMetallicRoughness(material, textures);
  addNormal(material, textures);
  material.emission_texture = textures.emission.use;
  material.emission_texture.image = read(textures.emission.file);
}

void MtlImages::warn() const {
  const auto list = [](const std::set<std::string>& names) {
    return listed(std::vector<std::string>(names.begin(), names.end()));
  };
  std::vector<std::string>& warnings = scene_->warnings;
  if (!missing_.empty())
    warnings.push_back(
        fmt::format("no picture {} beside the model; surfaces go without", list(missing_)));
  constexpr std::size_t kMostTold = 5;
  std::size_t told = 0;
  for (const std::string& reason : unread_) {
    if (++told > kMostTold) break;
    warnings.push_back(fmt::format("a texture is left out: {}", reason));
  }
  if (!heights_.empty())
    warnings.push_back(
        fmt::format("bump maps of heights are left out: {}; use maps of normals", list(heights_)));
}

}  // namespace glimt
