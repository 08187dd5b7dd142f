// What a PNG consists of, and texts in it.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace glimt {

struct PngChunk {
  std::string_view name;  // four letters
  std::string_view content;
};

// In their order, without the end. `bytes` begins with a PNG's signature, and outlives what is
// returned. Errors: input, for a chunk that is longer than the file.
std::vector<PngChunk> pngChunksOf(std::string_view bytes);

// The PNG with a text of that keyword (tEXt: Latin-1, the keyword up to 79 letters). `png` is
// whole.
std::string withPngText(const std::string& png, std::string_view keyword, std::string_view text);

// Whether there is a text of that keyword. Errors: as pngChunksOf's.
bool hasPngText(std::string_view bytes, std::string_view keyword);

}  // namespace glimt
