// The numbers of a glTF file's accessors, every one of which is looked for before it is read.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "renderer/core/vector.h"
#include "renderer/scene/gltf_document.h"

namespace glimt {

// No accessor of more elements is read, and no scene of more vertices made.
inline constexpr std::size_t kMostGltfVertices = 1 << 23;

// One vector an element, of components from `fewest` to `most` of 1 to 4; what it has not is 0, and
// the fourth 1. Integers that are normalised are in [-1, 1]. `who` has the accessor, as in
// "POSITION of mesh 3". Errors: input, for what is of another type, or beyond its buffer.
std::vector<Vec4> readGltfVectors(const GltfDocument& document, int accessor, int fewest, int most,
                                  const std::string& who);

// Of an accessor of unsigned integers.
std::vector<std::uint32_t> readGltfIndices(const GltfDocument& document, int accessor,
                                           const std::string& who);

}  // namespace glimt
