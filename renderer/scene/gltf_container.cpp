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

// Goes over a JSON text before it is read, and refuses what would take too much memory. (With its
// own callback nlohmann's parser takes time with the square of an array's length.)
class Limits : public nlohmann::json_sax<json> {
 public:
  explicit Limits(const std::string& path) : path_(path) {}

  bool null() override { return count(); }
  bool boolean(bool) override { return count(); }
  bool number_integer(number_integer_t) override { return count(); }
  bool number_unsigned(number_unsigned_t) override { return count(); }
  bool number_float(number_float_t, const string_t&) override { return count(); }
  bool string(string_t&) override { return count(); }
  bool binary(binary_t&) override { return count(); }
  bool key(string_t&) override { return true; }
  bool start_object(std::size_t) override { return begin(); }
  bool start_array(std::size_t) override { return begin(); }
  bool end_object() override { return end(); }
  bool end_array() override { return end(); }
  bool parse_error(std::size_t position, const std::string&,
                   const json::exception& error) override {
    fail(path_, fmt::format("not the JSON of a glTF file, at byte {} ({}); export the model again",
                            position, printable(error.what())));
  }

 private:
  bool count() {
    if (++values_ > kMostValues)
      fail(path_, fmt::format("more than {} values in the JSON; use a smaller model",
                              grouped(kMostValues)));
    return true;
  }
  bool begin() {
    if (++depth_ > kDeepest)
      fail(path_, fmt::format("nested deeper than {} levels; export the model again", kDeepest));
    return count();
  }
  bool end() {
    --depth_;
    return true;
  }

  const std::string& path_;
  int depth_ = 0;
  std::size_t values_ = 0;
};

// Takes memory in tinygltf, and nobody looks at it.
void removeExtras(json& value) {
  if (!value.is_structured()) return;
  if (value.is_object()) value.erase("extras");
  for (json& part : value) removeExtras(part);
}

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
  json::sax_parse(text.begin(), text.end(), &limits);
  json value = json::parse(text.begin(), text.end());
  if (!value.is_object()) fail(path, "the JSON is not an object; export the model again");
  value.erase("animations");
  removeExtras(value);
  return value;
}

}  // namespace glimt
