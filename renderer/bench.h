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

// --- One pass per bounce, or one shader ---------------------------------------------------------

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

// --- What an effect costs, called for or not ----------------------------------------------------

// Beside the names of effects.
inline constexpr const char* kOwnEffects = "none";  // nothing is changed: the scene's own effects
inline constexpr const char* kAllEffects = "all";
inline constexpr const char* kWithheld = "no_";  // before the name of one that is withheld

struct EffectsBenchSettings {
  int bounces = 4;
  int side = 512;           // pictures are side * side pixels
  int repeats = 25;         // samples; after one that is not timed
  int compile_repeats = 3;  // of all that is compiled
  bool forced = true;       // whether there are rows for those that the scene does not call for
};

// A scene without one effect that it calls for, or with one forced upon it that it does not call
// for, or with all of them.
struct EffectsRow {
  std::string scene;
  std::size_t triangles = 0;
  int bounces = 0;
  std::string traversal;
  std::string effect;  // its name, with kWithheld before it or not, kOwnEffects or kAllEffects
  std::vector<std::string> withheld;  // what is not compiled of the scene's own: it, and what
                                      // implies it
  std::vector<std::string>
      forced;  // what is compiled besides the scene's own: it and what it implies
  std::optional<Spread> compile_seconds;  // with what the driver leaves to the first draw
  std::optional<Spread> sample_seconds;   // none: the driver refuses the shader, see note
  // Of the seconds per sample to those of kOwnEffects in the same round.
  std::optional<Spread> ratio;
  // Whether the picture's mean is that of kOwnEffects, per channel; none where nothing was drawn,
  // and for what is withheld: it makes another picture.
  std::optional<bool> agrees;
  std::string note;
};

// The scene as it is comes first, then without each of its own effects, with each of the others,
// and all of them last. Not the parallel projection, which takes the place of a camera and adds
// nothing to it, nor a lens upon one, nor what the background brings. `progress` as above. Errors:
// as for Renderer.
std::vector<EffectsRow> benchEffects(ContextHandle& context, const Scene& scene, const Tree& tree,
                                     const EffectsBenchSettings& settings,
                                     const std::function<void(const std::string&)>& progress);

// --- What the device can do at most ----------------------------------------------------------

struct DeviceBenchSettings {
  std::vector<int> sides{512, 2048};  // pixels of the square pictures that are drawn
  // The largest that texels are fetched from, in bytes.
  std::size_t largest_texture = std::size_t{128} << 20;
  std::size_t triangles = 70000;  // about as many in the mesh that is traversed
  int ray_side = 512;             // rays are ray_side * ray_side
  int repeats = 7;                // after one that is not timed
};

// One kind of work that a traversal is made of, and nothing else.
struct DeviceRow {
  std::string work;
  std::string unit;            // of the rate
  int side = 0;                // of the picture, in pixels
  std::optional<Spread> rate;  // none: it cannot be done here, see note
  std::string note;
};

// What one ray takes on average, of those that are cast.
struct RayWork {
  double node_fetches = 0;      // texels of the tree
  double triangle_fetches = 0;  // texels of triangles
  double box_tests = 0;
  double triangle_tests = 0;

  double fetches() const { return node_fetches + triangle_fetches; }
};

// A traversal beside what the device could do at most.
struct TraversalBoundRow {
  std::size_t triangles = 0;
  std::string traversal;
  std::string rays;  // one of kRayKinds
  RayWork per_ray;
  Rate rate;  // measured
  // Of texels in the nearest caches, in thousand millions a second: the same one or neighbours for
  // camera rays, random ones for the others.
  double fetch_ceiling = 0;
  double fetch_bound = 0;       // million rays per second, if only the fetches took time
  double arithmetic_bound = 0;  // if only the tests of boxes and triangles did

  // Thousand millions a second, made by the traversal.
  double fetchRate() const { return per_ray.fetches() * rate.median / 1000; }
};

struct DeviceBench {
  std::vector<DeviceRow> ceilings;
  std::vector<TraversalBoundRow> bounds;
};

// `progress` is told what is being done. Errors: no_gl, failed.
DeviceBench benchDevice(ContextHandle& context, const DeviceBenchSettings& settings,
                        const std::function<void(const std::string&)>& progress);

}  // namespace glimt
