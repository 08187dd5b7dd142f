#include <fmt/format.h>
#include <tinyexr.h>

#include <cstdlib>
#include <cstring>
#include <memory>

#include "renderer/core/error.h"
#include "renderer/core/image_codecs.h"
#include "renderer/core/image_layers.h"
#include "renderer/core/wording.h"

namespace glimt {
namespace {

// Names in the file's header have an end of their own.
template <std::size_t Size>
void copyName(char (&to)[Size], const std::string& from) {
  const std::size_t length = from.copy(to, Size - 1);
  to[length] = '\0';
}

std::vector<EXRAttribute> attributesOf(const std::map<std::string, std::string>& notes) {
  std::vector<EXRAttribute> attributes;
  for (const auto& [name, text] : notes) {
    EXRAttribute& attribute = attributes.emplace_back();
    copyName(attribute.name, name);
    copyName(attribute.type, "string");
    // It is only read.
    attribute.value = reinterpret_cast<unsigned char*>(const_cast<char*>(text.data()));
    attribute.size = static_cast<int>(text.size());
  }
  return attributes;
}

}  // namespace

// A map's order is the one in which channels are stored: that of their names.
std::string encodeLayers(const ImageLayers& layers) {
  const std::size_t count = layers.channels.size();
  std::vector<unsigned char*> images;
  std::vector<EXRChannelInfo> channels;
  for (const auto& [name, values] : layers.channels) {
    images.push_back(reinterpret_cast<unsigned char*>(const_cast<float*>(values.data())));
    EXRChannelInfo& channel = channels.emplace_back();
    copyName(channel.name, name);
    channel.x_sampling = 1;
    channel.y_sampling = 1;
  }
  std::vector<int> types(count, TINYEXR_PIXELTYPE_FLOAT);
  std::vector<EXRAttribute> attributes = attributesOf(layers.notes);

  EXRImage source;
  InitEXRImage(&source);
  source.num_channels = static_cast<int>(count);
  source.images = images.data();
  source.width = layers.width;
  source.height = layers.height;
  EXRHeader header;
  InitEXRHeader(&header);
  header.num_channels = static_cast<int>(count);
  header.channels = channels.data();
  header.pixel_types = types.data();
  header.requested_pixel_types = types.data();
  header.compression_type = TINYEXR_COMPRESSIONTYPE_ZIP;
  header.num_custom_attributes = static_cast<int>(attributes.size());
  header.custom_attributes = attributes.data();

  unsigned char* memory = nullptr;
  const char* message = nullptr;
  const std::size_t size = SaveEXRImageToMemory(&source, &header, &memory, &message);
  const std::unique_ptr<unsigned char, void (*)(void*)> owner(memory, std::free);
  const std::unique_ptr<const char, void (*)(const char*)> reason(message, FreeEXRErrorMessage);
  if (size == 0)
    throw Error(ErrorKind::failed, fmt::format("cannot write EXR ({}); try .pfm",
                                               message ? printable(message) : "no reason given"));
  return std::string(reinterpret_cast<const char*>(memory), size);
}

std::string encodeExr(const Image& image) {
  return encodeLayers(layersOf(image));
}

}  // namespace glimt
