// Small files that glimt reads without complaint, several of each kind: what hostile variants and
// fuzzers begin with.
#pragma once

#include <string>
#include <vector>

namespace glimt {

struct GoodFile {
  std::string kind;  // as the extension: exr glb gltf hdr json mtl obj pfm png
  std::string name;
  std::string bytes;
};

std::vector<GoodFile> goodFiles();

// The small pictures among them, made with the libraries' own writers and with good_png.cpp.
std::vector<GoodFile> goodPictures();

// The glTF files among them.
std::vector<GoodFile> goodGltfs();

}  // namespace glimt
