#include "renderer/scene/gltf_container.h"

#include <fmt/format.h>

#include <cstdint>
#include <cstring>

#include "renderer/core/error.h"
#include "renderer/core/wording.h"

namespace glimt {
namespace {

using nlohmann::json;

// tinygltf goes into what is nested by recursion.
constexpr int kDeepest = 64;
// Each value may take some hundred bytes.
constexpr std::size_t kMostValues = 1 << 21;

constexpr std::uint32_t kJsonChunk = 0x4e4f534a;
constexpr std::uint32_t kBinaryChunk = 0x004e4942;
constexpr std::size_t kFileHeader = 12;
constexpr std::size_t kChunkHeader = 8;

[[noreturn]] void fail(const std::string& path, const std::string& what) {
  throw Error(ErrorKind::input, fmt::format("{}: {}", path, what));
}

std::uint32_t numberAt(std::string_view bytes, std::size_t position) {
  std::uint32_t number = 0;
  for (std::size_t i = 4; i-- > 0;)
    number = number << 8 | static_cast<unsigned char>(bytes[position + i]);
  return number;
}

struct Chunk {
  std::uint32_t kind;
  std::string_view content;
};

// Takes the first chunk off `bytes`.
Chunk takeChunk(std::string_view& bytes, const std::string& path) {
  if (bytes.size() < kChunkHeader) fail(path, "the .glb ends too early; export the model again");
  const std::size_t length = numberAt(bytes, 0);
  if (length > bytes.size() - kChunkHeader)
    fail(path, "a chunk of the .glb is longer than the file; export the model again");
  const Chunk chunk{numberAt(bytes, 4), bytes.substr(kChunkHeader, length)};
  bytes.remove_prefix(kChunkHeader + length);
  return chunk;
}

// Leaves out what is not looked at, and refuses what would take too much memory while it is read.
class Limits {
 public:
  explicit Limits(const std::string& path) : path_(path) {}

  bool keeps(int depth, json::parse_event_t event, const json& value) {
    if (depth > kDeepest)
      fail(path_, fmt::format("nested deeper than {} levels; export the model again", kDeepest));
    if (event == json::parse_event_t::key)
      return value != "extras" && !(depth == 1 && value == "animations");
    const bool begins = event == json::parse_event_t::value ||
                        event == json::parse_event_t::object_start ||
                        event == json::parse_event_t::array_start;
    if (begins && ++values_ > kMostValues)
      fail(path_, fmt::format("more than {} values in the JSON; use a smaller model",
                              grouped(kMostValues)));
    return true;
  }

 private:
  const std::string& path_;
  std::size_t values_ = 0;
};

}  // namespace

GltfChunks chunksOf(std::string_view bytes, const std::string& path) {
  if (!bytes.starts_with("glTF")) return {bytes, {}};
  if (bytes.size() < kFileHeader) fail(path, "the .glb ends too early; export the model again");
  const std::uint32_t version = numberAt(bytes, 4);
  if (version != 2)
    fail(path,
         fmt::format("a .glb of version {}; glimt reads version 2, export it as that", version));
  const std::size_t length = numberAt(bytes, 8);
  if (length > bytes.size() || length < kFileHeader)
    fail(path, fmt::format("the .glb says that it has {} bytes, but has {}; export the model again",
                           length, bytes.size()));
  bytes = bytes.substr(kFileHeader, length - kFileHeader);
  const Chunk first = takeChunk(bytes, path);
  if (first.kind != kJsonChunk)
    fail(path, "the first chunk of the .glb is not JSON; export the model again");
  GltfChunks chunks{first.content, {}};
  // What follows them is for others.
  if (!bytes.empty()) {
    const Chunk second = takeChunk(bytes, path);
    if (second.kind == kBinaryChunk) chunks.binary = second.content;
  }
  return chunks;
}

nlohmann::json parseGltfJson(std::string_view text, const std::string& path) {
  Limits limits(path);
  try {
    json value = json::parse(text.begin(), text.end(),
                             [&](int depth, json::parse_event_t event, const json& parsed) {
                               return limits.keeps(depth, event, parsed);
                             });
    if (!value.is_object()) fail(path, "the JSON is not an object; export the model again");
    return value;
  } catch (const json::parse_error& error) {
    fail(path, fmt::format("not the JSON of a glTF file, at byte {}; export the model again",
                           error.byte));
  } catch (const json::exception& error) {
    fail(path, fmt::format("not the JSON of a glTF file ({}); export the model again",
                           printable(error.what())));
  }
}

}  // namespace glimt
