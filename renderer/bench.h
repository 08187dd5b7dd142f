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

// Of the repeats of one measurement.
struct Spread {
  double median = 0;
  double least = 0;
  double most = 0;
};

using Rate = Spread;  // million rays per second

// In the order in which their rates are listed.
inline constexpr std::array kRayKinds{"camera", "bounce", "shadow"};

struct TraversalBenchSettings {
  std::vector<std::size_t> triangles{1000, 70000, 500000, 2000000};  // about as many in each mesh
  int side = 512;                                                    // rays are side * side
  int repeats = 7;                                                   // after one that is not timed
};

// One traversal on one mesh.
struct TraversalRow {
  std::string scene;
  std::size_t triangles = 0;
  std::string traversal;  // or "embree": the same rays on the processor, as a ceiling
  std::optional<std::array<Rate, kRayKinds.size()>> rates;  // none: it does not run here, see note
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

// Ways to trace the bounces of a path.
inline constexpr const char* kPasses = "passes";      // one pass per bounce: the renderer's
inline constexpr const char* kLoop = "loop";          // a loop in one shader
inline constexpr const char* kUnrolled = "unrolled";  // the same, written out

struct PassesBenchSettings {
  std::vector<std::size_t> triangles{70000};         // about as many in each knot, beside the box
  std::vector<int> bounces{1, 2, 3, 4, 5, 6, 7, 8};  // secondary bounces
  int side = 512;                                    // pictures are side * side pixels
  int repeats = 7;                                   // samples; after one that is not timed
};

// One way to trace the bounces, for one scene and number of bounces.
struct PassesRow {
  std::string scene;
  std::size_t triangles = 0;
  int bounces = 0;
  std::string variant;
  std::string traversal;
  std::optional<double> compile_seconds;  // with what the driver leaves to the first draw
  std::optional<Spread> sample_seconds;   // none: the driver refuses the shader, see note
  // Whether the picture's mean is that of the passes, per channel; none where nothing was drawn.
  std::optional<bool> agrees;
  std::string note;
};

// The rows of a scene and number of bounces follow each other, the passes first. `progress` as
// above. Errors: as for Renderer.
std::vector<PassesRow> benchPasses(ContextHandle& context, const PassesBenchSettings& settings,
                                   const std::function<void(const std::string&)>& progress);

}  // namespace glimt
