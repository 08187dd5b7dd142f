// glimt's renderer: a Scene in, a picture that converges out.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <limits>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "renderer/core/context_info.h"
#include "renderer/core/image.h"
#include "renderer/core/light_limits.h"
#include "renderer/core/noise_estimate.h"
#include "renderer/core/sampler.h"
#include "renderer/core/tone.h"
#include "renderer/core/traversal_time.h"
#include "renderer/core/work_progress.h"
#include "renderer/scene/scene.h"

namespace glimt {

namespace gl {
class Context;
}
struct SceneTree;

// --- Where GL comes from ---------------------------------------------------------------------

enum class Backend { automatic, egl, osmesa };

class ContextHandle {
 public:
  explicit ContextHandle(std::unique_ptr<gl::Context> context);
  ContextHandle(ContextHandle&&) noexcept;
  ContextHandle& operator=(ContextHandle&&) noexcept;
  ~ContextHandle();

  ContextInfo info() const;
  gl::Context& get() const { return *context_; }

 private:
  std::unique_ptr<gl::Context> context_;
};

// A context without a window, current on this thread. `gles` is 2 or 3. `automatic` prefers a GPU
// to a rasteriser in software, and EGL to OSMesa. Errors: no_gl, naming every way that was tried
// and what it answered.
ContextHandle createOffscreenContext(Backend backend, int gles);

// The context that a window library has made current on this thread.
using ProcLoader = std::function<void*(const char* name)>;
ContextHandle adoptCurrentContext(const ProcLoader& load);

// --- The tree ----------------------------------------------------------------------------------

// Over a scene's triangles, by which rays find them. It is made without GL, on any thread, and
// copies share it.
class Tree {
 public:
  // Takes seconds for millions of triangles, which `progress` is told of; what that throws ends the
  // work. Errors: input, for more triangles than any device can hold.
  explicit Tree(const Scene& scene, const WorkProgress& progress = {});

  const SceneTree& get() const { return *tree_; }
  const std::shared_ptr<const SceneTree>& shared() const { return tree_; }

 private:
  std::shared_ptr<const SceneTree> tree_;
};

// --- Rendering -------------------------------------------------------------------------------

// How a scene differs from one with the same triangles.
enum class MaterialChange {
  any,     // which triangle has which material, and the pictures on them; lights, environment
  numbers  // only numbers and colours of materials, and the environment's but for its picture
};

struct RenderSettings {
  int width = 512;
  int height = 512;
  int bounces = 4;  // secondary bounces: a path has at most bounces + 1 scattering surfaces
  // Same seed, context and traversal: the same picture, bit for bit. On llvmpipe all traversals
  // give the same one, too.
  std::uint32_t seed = 0;
  std::string traversal = "auto";  // the likeliest to be fast; after two seconds, the fastest
  std::string record = "packed";   // how hits are kept: "packed", or "wide", which needs ES 3.0
  Sampler sampler = Sampler::sobol;
  std::optional<float> clamp;  // see LightLimits; none: samples are as bright as they are
  bool roulette = true;        // paths that carry little light may end at random: less work, as
                               // exact in the mean
  // Of the sequence of samples: those before are drawn elsewhere.
  int first_sample = 0;
  // What is kept beside the radiance, at the price of one more draw a sample each.
  bool keep_spread = false;        // Picture::spread
  bool keep_path_lengths = false;  // Picture::path_lengths; not over a transparent background
};

struct RenderStatistics {
  std::string traversal;                       // the variant in use
  std::vector<TraversalTime> traversal_times;  // what "auto" measured before it took that one
  std::size_t triangles = 0;
  std::size_t nodes = 0;              // of the BVH
  std::size_t texture_bytes = 0;      // geometry, tree and materials on the GPU
  std::vector<std::string> warnings;  // what could not be kept as the scene has it
  double bvh_seconds = 0;
  double compile_seconds = 0;
  // Rays per picture of one sample, counted in the first one. Shadow rays are counted as one for
  // each hit, though some are not cast, since no light can arrive; bounce rays as one for each path
  // that scatters, though roulette ends some paths there.
  double camera_rays = 0;
  double bounce_rays = 0;
  double shadow_rays = 0;
  double noise_seconds = 0;  // spent on measuring the noise
};

// Pixels that are left out of the mean.
struct Losses {
  int cut_short = 0;   // the traversal of a ray was ended early, by the driver or after MAX_STEPS
  int not_finite = 0;  // the sample was not a number, or not a possible one
};

// On the CPU, out of reach of what happens to the context.
struct Picture {
  // The mean; pixels without a sample are black. It has an alpha where the scene's background is
  // transparent.
  Image radiance;
  int samples = 0;
  double mean_samples = 0;   // over the pixels: fewer where some rest, see restBelow()
  int nonfinite_pixels = 0;  // that have lost a sample, see nonfinitePixels()
  // For each pixel, rows from the top.
  std::vector<float> pixel_samples = {};  // that are in its mean
  std::vector<float> spread = {};        // standard deviation of its samples' luminance, where kept
  std::vector<float> path_lengths = {};  // surfaces that its paths met, in the mean, where kept
};

// What the camera's rays meet first, for each pixel, rows from the top. Zeros where they meet
// nothing.
struct FirstHits {
  std::vector<Vec3> albedo;     // base colour
  std::vector<Vec3> normal;     // for shading, world space, on the camera's side
  std::vector<float> depth;     // metres along the view
  std::vector<float> material;  // 1 + its index in Scene::materials, of one ray
  std::vector<float> coverage;  // share of the rays that met anything
};

// Which picture is shown.
enum class Shown { samples, denoised };

class Renderer {
 public:
  // Builds the tree, uploads the scene and compiles the programs that the scene calls for. The
  // context is current and outlives the renderer. `progress` is told how far the tree is, which
  // takes seconds for millions of triangles, and 1 again before each shader is compiled.
  // Errors: usage for an unknown traversal or record, or one that the context lacks, input for a
  // scene larger than the device's textures or, with traversal "linear", with more triangles than a
  // loop makes turns on this device, no_gl where the device has no float target, failed for a
  // shader that does not compile and where GL is out of memory or loses the context.
  Renderer(ContextHandle& context, const Scene& scene, const RenderSettings& settings,
           const WorkProgress& progress = {});
  // The same with a tree that is there already: that of the scene, or of one that differs from it
  // only in its materials.
  Renderer(ContextHandle& context, const Scene& scene, const Tree& tree,
           const RenderSettings& settings, const WorkProgress& progress = {});
  Renderer(Renderer&&) noexcept;
  Renderer& operator=(Renderer&&) noexcept;
  ~Renderer();

  // The same triangles with other materials, as in another variant of their file; lights,
  // environment and camera become those of `scene` too. The tree is kept, and so is every program
  // that its effects do not change. What is said to have changed only in numbers is not compared,
  // and takes as long as materials are many, not triangles. Errors: usage, where a triangle is not
  // where it was; else as the constructor's, after which the renderer is as it was.
  void setMaterials(const Scene& scene, MaterialChange change = MaterialChange::any);

  // Starts the picture again.
  void setCamera(const Camera& camera);
  void resize(int width, int height);

  // The same with other limits, and with other random numbers. There can be a clamp only if
  // RenderSettings had one.
  void setLimits(const LightLimits& limits);
  void setSampler(Sampler sampler, std::uint32_t seed);

  // Lets parts of the picture rest, that is, get no more samples, where their noise is already what
  // is best for a noise of the whole of `goal` (as NoiseEstimate::upper) in the least time. None:
  // all pixels have all samples, as at first. To be set before the first sample. Does nothing where
  // the device cannot limit draws to a part of the pixels.
  void restBelow(std::optional<double> goal);

  // Adds one sample to every pixel that is not at rest. Errors, here and in advance(): failed, when
  // GL is out of memory, loses the context or notes another error. The complete samples stay, and
  // picture() hands them out where the context still can.
  void renderSample();

  // Works for about `seconds`, in draws that are each much shorter, and leaves the rest of a sample
  // for the next call. Ends early when the picture has `most_samples`.
  void advance(double seconds, int most_samples = std::numeric_limits<int>::max());

  // Complete samples in the picture.
  int samples() const;

  // The complete samples so far. Errors: failed, when the context is lost.
  Picture picture();
  Image radiance();  // of it

  // The picture with less noise, for previews: an edge-avoiding filter, guided by what is seen and
  // by how sure the samples are. The picture stays as it is, and so does noise(), which is that of
  // the samples. A sample under way is completed first; there is one at least. It knows best how
  // sure they are with RenderSettings::keep_spread. Compiled when it is called first; called again
  // it takes a part of the time. `progress` as the constructor's. Errors: as renderSample's.
  Image denoised(const WorkProgress& progress = {});

  // The means over so many of the first rays of each pixel, of those that meet something. The
  // picture stays as it is; a sample under way is completed first. Errors: as renderSample's.
  FirstHits firstHits(int rays);

  // How wrong the picture still is by chance; nothing before it has 8 samples. noise() measures at
  // most so often that it takes a hundredth of the time, and may be of some samples ago. noiseNow()
  // is of this picture. Errors: failed, when the context is lost.
  std::optional<NoiseEstimate> noise();
  std::optional<NoiseEstimate> noiseNow();

  // Pixels that have lost a sample to a value that was not finite, or to a traversal cut short.
  int nonfinitePixels();

  // What the last sample's pixels among them lost it to.
  Losses lastLosses();

  // After how many turns the driver ends the loops of a shader, without a word; none where 2^18
  // turns are made. Measured at the call.
  std::optional<std::uint32_t> loopLimit();

  // The picture as a display shows it: radiance * 2^exposure, brought into 0 to 1 by the tone,
  // sRGB-encoded. Denoised it takes as long as denoised(), and so it does in present().
  DisplayImage display(float exposure, Tone tone = Tone::srgb, Shown shown = Shown::samples);

  // Draws the same into the window's framebuffer, scaled to its size in pixels.
  void present(int framebuffer_width, int framebuffer_height, float exposure,
               Tone tone = Tone::srgb, Shown shown = Shown::samples);

  RenderStatistics statistics() const;

  // The fragment shaders of the passes, as they are compiled, by the passes' names.
  std::map<std::string, std::string> shaders() const;

 private:
  class State;
  std::unique_ptr<State> state_;
};

}  // namespace glimt
