// KHR_materials_variants: other materials for the same primitives, by the name of a variant.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "renderer/scene/gltf_document.h"

namespace glimt {

std::vector<std::string> variantNames(const tinygltf::Model& model);

// The primitive's material in that variant, of variantNames(), or without one; -1: none.
int materialOf(const tinygltf::Primitive& primitive, std::optional<std::size_t> variant);

}  // namespace glimt
