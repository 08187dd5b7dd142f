#include "renderer/shader/traversals.h"

#include <fmt/format.h>

#include "renderer/core/error.h"

namespace glimt {

const std::vector<Traversal>& traversals() {
  static const std::vector<Traversal> kTraversals{
      {"octant-ahead",
       TreeLayout::octants,
       {"octant_nodes.glsl", "traverse_octant_ahead.glsl", "traverse_leaves.glsl"},
       "skip links per ray octant, two nodes a step"},
      {"octant",
       TreeLayout::octants,
       {"octant_nodes.glsl", "traverse_octant.glsl", "traverse_leaves.glsl"},
       "skip links per ray octant"},
      {"stack",
       TreeLayout::pairs,
       {"box.glsl", "traverse_stack.glsl", "traverse_leaves.glsl"},
       "stack in shifted registers"},
      {"trail",
       TreeLayout::pairs,
       {"box.glsl", "traverse_trail.glsl", "traverse_leaves.glsl"},
       "restart trail in float arithmetic"},
      {"skip",
       TreeLayout::once,
       {"box.glsl", "traverse_skip.glsl", "traverse_leaves.glsl"},
       "skip links in one order"},
      {"linear", TreeLayout::none, {"traverse_linear.glsl"}, "every triangle"},
  };
  return kTraversals;
}

std::vector<std::string> traversalNames() {
  std::vector<std::string> names;
  for (const Traversal& traversal : traversals()) names.push_back(traversal.name);
  return names;
}

const Traversal& traversalNamed(const std::string& name) {
  for (const Traversal& traversal : traversals())
    if (name == traversal.name) return traversal;
  throw Error(ErrorKind::usage, fmt::format("there is no traversal '{}'; there are: auto, {}", name,
                                            fmt::join(traversalNames(), ", ")));
}

}  // namespace glimt
