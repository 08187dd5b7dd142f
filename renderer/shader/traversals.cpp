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
       {"box.glsl", "skip_walk.glsl", "octant_nodes.glsl", "traverse_octant_ahead.glsl",
        "traverse_leaves.glsl"},
       kAnyDepth},
      {"octant",
       TreeLayout::octants,
       {"box.glsl", "skip_walk.glsl", "octant_nodes.glsl", "traverse_octant.glsl",
        "traverse_leaves.glsl"},
       kAnyDepth},
      {"stack",
       TreeLayout::pairs,
       {"box.glsl", "node_pair.glsl", "traverse_stack.glsl", "traverse_leaves.glsl"},
       STACK_SIZE},
      {"trail",
       TreeLayout::pairs,
       {"box.glsl", "node_pair.glsl", "trail_float.glsl", "trail_step.glsl", "traverse_trail.glsl",
        "traverse_leaves.glsl"},
       TRAIL_SIZE},
      {"parent",
       TreeLayout::triples,
       {"box.glsl", "traverse_parent.glsl", "traverse_leaves.glsl"},
       kAnyDepth},
      {"skip",
       TreeLayout::once,
       {"box.glsl", "skip_walk.glsl", "traverse_skip.glsl", "traverse_leaves.glsl"},
       kAnyDepth},
      {"linear", TreeLayout::none, {"traverse_linear.glsl"}, kAnyDepth},
      {"trail-bits",
       TreeLayout::pairs,
       {"box.glsl", "node_pair.glsl", "trail_bits.glsl", "trail_step.glsl", "traverse_trail.glsl",
        "traverse_leaves.glsl"},
       TRAIL_BITS,
       3},
      {"short-stack",
       TreeLayout::pairs,
       {"box.glsl", "node_pair.glsl", "trail_bits.glsl", "trail_step.glsl",
        "traverse_short_stack.glsl", "traverse_leaves.glsl"},
       TRAIL_BITS,
       3},
      {"array-stack",
       TreeLayout::pairs,
       {"box.glsl", "node_pair.glsl", "traverse_array_stack.glsl", "traverse_leaves.glsl"},
       STACK_SIZE,
       3},
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
