#include "renderer/scene/gltf_document.h"

#include <fmt/format.h>

#include <array>
#include <nlohmann/json.hpp>

#include "renderer/core/error.h"
#include "renderer/core/file.h"
#include "renderer/core/wording.h"
#include "renderer/scene/gltf_container.h"
#include "renderer/scene/gltf_extensions.h"
#include "renderer/scene/gltf_uri.h"

namespace glimt {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

// With the scene that is made of it below 2 GiB of memory.
constexpr std::uintmax_t kLargestGltf = 512 << 20;

// tinygltf takes up to two thousand bytes for each.
struct Collection {
  const char* name;
  std::size_t most;
};
constexpr std::array kCollections = {
    Collection{"accessors", 1 << 18}, Collection{"bufferViews", 1 << 18},
    Collection{"buffers", 1 << 12},   Collection{"cameras", 1 << 12},
    Collection{"images", 1 << 14},    Collection{"materials", 1 << 16},
    Collection{"meshes", 1 << 18},    Collection{"nodes", 1 << 18},
    Collection{"samplers", 1 << 14},  Collection{"scenes", 1 << 12},
    Collection{"skins", 1 << 12},     Collection{"textures", 1 << 16}};

const json& arrayIn(const json& object, const char* key) {
  static const json kNone = json::array();
  const auto found = object.find(key);
  return found != object.end() && found->is_array() ? *found : kNone;
}

std::string textIn(const json& object, const char* key) {
  if (!object.is_object()) return {};
  const auto found = object.find(key);
  return found != object.end() && found->is_string() ? found->get<std::string>() : std::string();
}

void demandSensible(const json& root, const GltfDocument& document) {
  const auto asset = root.find("asset");
  const std::string version = asset == root.end() ? "" : textIn(*asset, "version");
  if (!version.starts_with("2."))
    document.fail(fmt::format("glTF of version '{}'; glimt reads version 2.0, export it as that",
                              printable(version)));
  for (const Collection& collection : kCollections) {
    const auto found = root.find(collection.name);
    if (found == root.end()) continue;
    if (!found->is_array())
      document.fail(
          fmt::format("\"{}\" must be an array; export the model again", collection.name));
    if (found->size() > collection.most)
      document.fail(fmt::format("more than {} {}; use a smaller model", grouped(collection.most),
                                collection.name));
  }
  std::size_t primitives = 0;
  for (const json& mesh : arrayIn(root, "meshes"))
    if (mesh.is_object()) primitives += arrayIn(mesh, "primitives").size();
  constexpr std::size_t kMostPrimitives = 1 << 18;
  if (primitives > kMostPrimitives)
    document.fail(
        fmt::format("more than {} primitives; use a smaller model", grouped(kMostPrimitives)));
}

std::vector<std::string> textsIn(const json& root, const char* key) {
  std::vector<std::string> texts;
  for (const json& text : arrayIn(root, key))
    if (text.is_string()) texts.push_back(text.get<std::string>());
  return texts;
}

std::vector<std::string> readBuffers(const json& root, std::string_view binary,
                                     const GltfDocument& document) {
  std::vector<std::string> buffers;
  std::uintmax_t left = kLargestGltf;
  for (const json& buffer : arrayIn(root, "buffers")) {
    const std::string who = fmt::format("buffer {}", buffers.size());
    if (!buffer.is_object() || !buffer.contains("byteLength") ||
        !buffer["byteLength"].is_number_unsigned())
      document.fail(who + " has no byteLength; export the model again");
    const auto length = buffer["byteLength"].get<std::uint64_t>();
    const std::string uri = textIn(buffer, "uri");
    // Only the first may be the .glb's own; another without a URI is a place for an extension.
    if (uri.empty())
      buffers.emplace_back(buffers.empty() ? binary : std::string_view());
    else
      buffers.push_back(readGltfUri(document.path, uri, who, left));
    std::string& bytes = buffers.back();
    if (bytes.size() < length && (!uri.empty() || !bytes.empty()))
      document.fail(fmt::format("{} says that it has {} bytes, but has {}; export the model again",
                                who, length, bytes.size()));
    if (bytes.size() > length) bytes.resize(static_cast<std::size_t>(length));
    left -= bytes.size();
  }
  return buffers;
}

std::vector<GltfImageSource> readImages(const json& root, const GltfDocument& document) {
  std::vector<GltfImageSource> images;
  for (const json& image : arrayIn(root, "images")) {
    GltfImageSource source;
    source.uri = textIn(image, "uri");
    source.name = textIn(image, "name");
    if (image.is_object() && image.contains("bufferView") &&
        image["bufferView"].is_number_unsigned())
      source.buffer_view = image["bufferView"].get<int>();
    if (source.uri.empty() && source.buffer_view < 0)
      document.fail(fmt::format(
          "image {} is neither a file nor in a buffer; export the model again", images.size()));
    if (source.name.empty() && !source.uri.starts_with("data:")) source.name = source.uri;
    if (source.name.empty()) source.name = fmt::format("image {}", images.size());
    images.push_back(std::move(source));
  }
  return images;
}

// tinygltf would read buffers and images without looking at where they are and how large; and it
// wants every index in a buffer, while Draco's are packed with the vertices.
void removeWhatIsReadHere(json& root) {
  for (const char* key : {"buffers", "images"}) root.erase(key);
  const auto meshes = root.find("meshes");
  if (meshes == root.end()) return;
  for (json& mesh : *meshes) {
    if (!mesh.is_object() || !mesh.contains("primitives") || !mesh["primitives"].is_array())
      continue;
    for (json& primitive : mesh["primitives"]) {
      if (!primitive.is_object() || !primitive.contains("extensions")) continue;
      const json& extensions = primitive["extensions"];
      if (extensions.is_object() && extensions.contains("KHR_draco_mesh_compression"))
        primitive.erase("indices");
    }
  }
}

void readModel(const json& root, GltfDocument& document) {
  const std::string text = root.dump(-1, ' ', false, json::error_handler_t::replace);
  std::string errors;
  std::string ignored_warnings;
  bool read = false;
  try {
    read = tinygltf::TinyGLTF().LoadASCIIFromString(&document.model, &errors, &ignored_warnings,
                                                    text.data(),
                                                    static_cast<unsigned int>(text.size()), "");
  } catch (const std::bad_alloc&) {
    throw;
  } catch (const std::exception& error) {
    errors = error.what();
  }
  if (read) return;
  while (!errors.empty() && (errors.back() == '\n' || errors.back() == '.')) errors.pop_back();
  document.fail(fmt::format("not valid glTF ({}); export the model again", printable(errors)));
}

}  // namespace

void GltfDocument::fail(const std::string& what) const {
  throw Error(ErrorKind::input, fmt::format("{}: {}", printable(path.string()), what));
}

std::string_view GltfDocument::bytesOf(int buffer_view, const std::string& who) const {
  if (buffer_view < 0 || static_cast<std::size_t>(buffer_view) >= model.bufferViews.size())
    fail(fmt::format("{} uses buffer view {}, but the file has {}; export the model again", who,
                     buffer_view, model.bufferViews.size()));
  const tinygltf::BufferView& view = model.bufferViews[static_cast<std::size_t>(buffer_view)];
  if (view.buffer < 0 || static_cast<std::size_t>(view.buffer) >= buffers.size())
    fail(fmt::format("buffer view {} uses buffer {}, but the file has {}; export the model again",
                     buffer_view, view.buffer, buffers.size()));
  const std::string_view buffer = buffers[static_cast<std::size_t>(view.buffer)];
  if (view.byteOffset > buffer.size() || view.byteLength > buffer.size() - view.byteOffset)
    fail(fmt::format("buffer view {} reaches beyond its buffer of {} bytes; export the model again",
                     buffer_view, buffer.size()));
  return buffer.substr(view.byteOffset, view.byteLength);
}

GltfDocument readGltfDocument(const fs::path& path) {
  GltfDocument document;
  document.path = path;
  const std::string shown_path = printable(path.string());
  const std::string bytes = readFile(path, kLargestGltf);
  const GltfChunks chunks = chunksOf(bytes, shown_path);
  json root = parseGltfJson(chunks.json, shown_path);
  demandSensible(root, document);
  checkGltfExtensions(textsIn(root, "extensionsRequired"), textsIn(root, "extensionsUsed"),
                      document);
  document.buffers = readBuffers(root, chunks.binary, document);
  document.images = readImages(root, document);
  removeWhatIsReadHere(root);
  readModel(root, document);
  return document;
}

}  // namespace glimt
