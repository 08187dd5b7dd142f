// Measures the renderer's parts on the device at hand, each for itself.
#pragma once

#include <array>
#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "renderer/renderer.h"

namespace glimt {

// Million rays per second over the repeats.
struct Rate {
  double median = 0;
  double least = 0;
  double most = 0;
};

// In the order in which their rates are listed.
inline constexpr std::array kRayKinds{"camera", "bounce", "shadow"};

struct TraversalBenchSettings {
  std::vector<std::size_t> triangles{1000, 70000, 500000, 2000000};  // about as many in each mesh
  int side = 512;                                                    // rays are side * side
  int repeats = 7;  // after one that is not timed; with 0 hits are compared and there are no rates
};

// One traversal on one mesh.
struct TraversalRow {
  std::string scene;
  std::size_t triangles = 0;
  std::string traversal;  // or "embree": the same rays on the processor, as a ceiling
  std::optional<std::array<Rate, kRayKinds.size()>> rates;  // none: it was not timed, see note
  std::optional<double> compile_seconds;                    // none for Embree
  std::optional<double> gpu_bytes_per_triangle;             // none for Embree
  double bvh_seconds = 0;
  std::string reference;      // whose hits these were compared with
  std::size_t different = 0;  // rays that hit something else than the reference's
  std::size_t compared = 0;
  bool agrees = false;
  std::string note;
};

inline constexpr const char* kEmbree = "embree";

// Where glimt is built with Embree it has rows of its own, and its hits are the reference;
// elsewhere the reference is traversal "skip". `progress` is told what is being done. Errors: input
// for a mesh that no traversal can hold, no_gl, failed.
std::vector<TraversalRow> benchTraversals(ContextHandle& context,
                                          const TraversalBenchSettings& settings,
                                          const std::function<void(const std::string&)>& progress);

}  // namespace glimt
