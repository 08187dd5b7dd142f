// What a URI in a glTF file stands for.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>

namespace glimt {

// The bytes in a data URI, or of a file in the model's folder or below it. `model` is the glTF
// file, `who` names what has the URI, for messages. Errors: input, for what cannot be read, for
// other places, and for more than `largest` bytes.
std::string readGltfUri(const std::filesystem::path& model, const std::string& uri,
                        const std::string& who, std::uintmax_t largest);

}  // namespace glimt
