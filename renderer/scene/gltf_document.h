// A glTF 2.0 file, taken apart: what its JSON says, and the bytes of its buffers.
#pragma once

#include <tiny_gltf.h>

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace glimt {

// Of an image exactly one is given.
struct GltfImageSource {
  std::string name;  // for messages
  std::string uri;
  int buffer_view = -1;
};

// tinygltf says what the JSON holds, and checks no index, length or count in it: whoever follows
// one does.
struct GltfDocument {
  std::filesystem::path path;
  tinygltf::Model model;  // without buffers, images and animations
  std::vector<std::string> buffers;
  std::vector<GltfImageSource> images;
  std::vector<std::string> warnings;  // one line each, for people

  // Throws Error input, "PATH: WHAT".
  [[noreturn]] void fail(const std::string& what) const;

  // What the view covers. `who` asks for it, for the message. Errors: input, when there is no such
  // view, or it reaches beyond its buffer.
  std::string_view bytesOf(int buffer_view, const std::string& who) const;
};

// Reads a .gltf or .glb, told apart by their content, and the files that its buffers name. Errors:
// input, also for what the file requires and glimt does not know.
GltfDocument readGltfDocument(const std::filesystem::path& path);

}  // namespace glimt
