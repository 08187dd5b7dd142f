// The two ways a glTF file is stored: as JSON, or as JSON and bytes in the chunks of a .glb.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <string_view>

namespace glimt {

struct GltfChunks {
  std::string_view json;
  std::string_view binary;  // empty: none
};

// Views of `bytes`, the content of a file. `path` is for messages. Errors: input, for a .glb whose
// chunks are not in it.
GltfChunks chunksOf(std::string_view bytes, const std::string& path);

// What the text says, without `extras` and animations. Errors: input, for what is no JSON, nests
// too deep, or has more parts than memory should be spent on.
nlohmann::json parseGltfJson(std::string_view text, const std::string& path);

}  // namespace glimt
