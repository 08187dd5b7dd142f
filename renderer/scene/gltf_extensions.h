// Which extensions of glTF are read, and how they are looked into.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "renderer/scene/gltf_document.h"

namespace glimt {

// Errors: input, naming what the file requires and glimt does not know. What it only uses becomes a
// warning.
void checkGltfExtensions(const std::vector<std::string>& required,
                         const std::vector<std::string>& used, GltfDocument& document);

// The object of that name in the map of a material, node or other part; null: not there.
const tinygltf::Value* extensionOf(const tinygltf::ExtensionMap& extensions, const char* name);

// The member of an object. Null, or nothing: not there, or of another type.
const tinygltf::Value* memberOf(const tinygltf::Value& object, const char* key);
std::optional<double> numberOf(const tinygltf::Value& object, const char* key);
std::optional<int> indexOf(const tinygltf::Value& object, const char* key);
// The array of exactly `size` numbers; empty: not there.
std::vector<double> numbersOf(const tinygltf::Value& object, const char* key, std::size_t size);

}  // namespace glimt
