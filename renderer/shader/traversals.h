// The traversals there are. Each is a shader file of its own over one layout of the tree.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace glimt {

// What a traversal finds in the texture of nodes.
enum class TreeLayout {
  none,     // it reads no tree
  octants,  // depth first, eight copies
  once,     // depth first
  pairs,    // children side by side
  triples,  // the same with the way up between them
};

struct Traversal {
  std::string name;
  TreeLayout layout;
  std::vector<std::string> files;  // in the order in which they are put together
  std::size_t most_levels;         // the largest stackSizeOf() that it holds
  int gles = 2;                    // the least OpenGL ES version that it runs on
};

// All of them, those first that are tried first.
const std::vector<Traversal>& traversals();

std::vector<std::string> traversalNames();

// Errors: usage, for a traversal that does not exist.
const Traversal& traversalNamed(const std::string& name);

}  // namespace glimt
