#include "renderer/shader/traversals.h"

#include <fmt/format.h>

#include <limits>

#include "renderer/core/error.h"
#include "shaders/layout.h"

namespace glimt {
namespace {

constexpr std::size_t kAnyDepth = std::numeric_limits<std::size_t>::max();

}  // namespace

const std::vector<Traversal>& traversals() {
  static const std::vector<Traversal> kTraversals{
      {"octant-ahead",
       TreeLayout::octants,
       {"octant_nodes.glsl", "traverse_octant_ahead.glsl", "traverse_leaves.glsl"},
       kAnyDepth,
       "skip links per ray octant, two nodes a step"},
      {"octant",
       TreeLayout::octants,
       {"octant_nodes.glsl", "traverse_octant.glsl", "traverse_leaves.glsl"},
       kAnyDepth,
       "skip links per ray octant"},
      {"stack",
       TreeLayout::pairs,
       {"box.glsl", "traverse_stack.glsl", "traverse_leaves.glsl"},
       STACK_SIZE,
       "stack in shifted registers"},
      {"trail",
       TreeLayout::pairs,
       {"box.glsl", "traverse_trail.glsl", "traverse_leaves.glsl"},
       TRAIL_SIZE,
       "restart trail in float arithmetic"},
      {"skip",
       TreeLayout::once,
       {"box.glsl", "traverse_skip.glsl", "traverse_leaves.glsl"},
       kAnyDepth,
       "skip links in one order"},
      {"linear", TreeLayout::none, {"traverse_linear.glsl"}, kAnyDepth, "every triangle"},
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
