// The triangles of one primitive of a glTF mesh, in the mesh's own space.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "renderer/core/vector.h"
#include "renderer/scene/gltf_document.h"

namespace glimt {

// All but the triangles: one a vertex, or empty where the primitive gives none.
struct GltfGeometry {
  std::vector<Vec4> positions;
  std::vector<Vec4> normals;
  std::array<std::vector<Vec4>, 2> texcoords;
  std::vector<Vec4> colors;  // linear, with alpha
  std::vector<std::array<std::uint32_t, 3>> triangles;
};

// Whether anything of it is drawn: it has positions, and is neither points nor lines.
bool hasTriangles(const tinygltf::Primitive& primitive);

// Of one that has triangles. `who` has it, for messages. Errors: input.
GltfGeometry readGltfPrimitive(const GltfDocument& document, const tinygltf::Primitive& primitive,
                               const std::string& who);

}  // namespace glimt
