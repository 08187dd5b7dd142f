// A Scene from a glTF 2.0 file, .gltf or .glb.
#pragma once

#include <filesystem>
#include <string>

#include "renderer/scene/scene.h"

namespace glimt {

// The scene is not checked yet. Instances are written out as triangles. `variant` is the name of
// one of the file's, or empty. Errors: input, "PATH: what is wrong; what to do"; usage, for a
// variant that the file does not have.
Scene readGltfFile(const std::filesystem::path& path, const std::string& variant);

}  // namespace glimt
