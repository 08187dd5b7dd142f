// The ping-pong loop: one pass per bounce, each cut into tiles.
#pragma once

#include <array>
#include <map>
#include <optional>
#include <string>
#include <tuple>
#include <vector>

#include "renderer/core/light_limits.h"
#include "renderer/gl/device.h"
#include "renderer/gl/program.h"
#include "renderer/gl/query.h"
#include "renderer/passes/accumulations.h"
#include "renderer/passes/film.h"
#include "renderer/passes/ray_census.h"
#include "renderer/passes/sample_points.h"
#include "renderer/passes/scene_textures.h"
#include "renderer/scene/effects_of.h"
#include "renderer/shader/composer.h"
#include "renderer/shader/records.h"

namespace glimt {

// What is told of a path to the denoiser, in as many targets.
inline constexpr std::size_t kGuides = 2;

struct PathTracerSettings {
  int bounces = 4;
  std::uint32_t seed = 0;
  std::string traversal = "auto";
  std::string record = "packed";  // see records.h
  Sampler sampler = Sampler::sobol;
  std::optional<float> clamp = std::nullopt;  // see LightLimits
  bool roulette = true;                       // weak paths may end at random
  bool live_only =
      true;  // passes are drawn for live paths only, where the device can; same picture
  // In a scene with light the picture with forced effects is the same but for its noise; without
  // some that are called for it is another.
  EffectChange change = {};
  int first_sample = 0;       // of the sequence; those before are another tracer's
  bool path_lengths = false;  // Accumulated::path_length is kept, where the background is not
                              // transparent
  bool squares = false;       // Accumulated::square is kept
};

class PathTracer {
 public:
  // `progress` is told how far the tree is, and 1 again before each further piece of work. Errors:
  // usage, also for a record that does not exist or does not run on the context.
  PathTracer(const gl::Device& device, const Scene& scene, const PathTracerSettings& settings,
             const WorkProgress& progress = {});
  PathTracer(const gl::Device& device, const Scene& scene, const PathTracerSettings& settings,
             const SceneTree& tree, const WorkProgress& progress = {});

  // Another scene of the same triangles, with the tree over them. What it calls for and is not
  // there yet is compiled. Errors: as the constructor's; all is as it was then.
  void setMaterials(const Scene& scene, const SceneTree& tree);

  // The same for a scene of which only numbers are others, see MaterialChange::numbers.
  void setNumbers(const Scene& scene, const SceneTree& tree);

  // Compiles where the camera calls for other effects than the one before.
  void setCamera(const Camera& camera);
  void resize(int width, int height);

  // Begins again with other limits. Only a tracer that was made with a clamp can have one.
  void setLimits(const LightLimits& limits);

  // Begins again with other random numbers.
  void setSampler(Sampler sampler, std::uint32_t seed);
  Sampler sampler() const { return points_.sampler(); }

  // Forgets all samples, and lets nothing rest.
  void restart();

  // Whether parts of the picture can rest. The noise by which that is decided is not that of
  // shadows on a catcher.
  bool canRest() const { return live_only_ && !has(effects_, Effect::shadow_catcher); }

  // These pixels get no more samples, from the sample on that begins.
  void rest(std::vector<gl::Tile> tiles) { resting_ = std::move(tiles); }

  // What may draw a sample: the traversal asked for or, for "auto", several.
  const std::vector<std::string>& candidates() const { return candidates_; }

  // Draws with another of the candidates, from the sample on that begins. The picture is the same.
  void use(const std::string& traversal);

  // The pass that the next draw belongs to.
  Pass nextPass() const { return stages_[stage_].pass; }

  // Whether the next draw begins a sample.
  bool atSampleStart() const { return stage_ == 0 && row_ == 0 && column_ == 0; }

  // One draw, of at most about `pixels` pixels. Returns how many they were. Errors: failed, when
  // GL fails; what was complete before stays so.
  double drawTile(double pixels);

  // What the camera's rays of a sample meet, as first_hit.glsl tells it, rows from the bottom. To
  // be called at a sample's start; which one it is does not matter to those of the picture.
  std::vector<Vec4> firstHits(int sample, int wanted);

  // What the paths of a sample come to, as guide.glsl tells it, one target for each that can be
  // wanted there: the first surface that is no mirror and no smooth glass. To be called at a
  // sample's start; which one it is does not matter to those of the picture.
  void drawGuides(int sample, const std::array<const gl::Target*, kGuides>& targets);

  // Right after the draw that completed a sample: it is not counted. Pixels that have it keep it,
  // each with its own number of samples.
  void takeBackSample();

  // The fragment shaders of the passes in use, as they are compiled, by the passes' names.
  std::map<std::string, std::string> shaders() const;

  int samples() const { return samples_; }
  const Film& film() const { return film_; }
  const Camera& camera() const { return camera_; }
  const Accumulation& accumulation() const { return accumulations_.picture(); }
  const Accumulation* kept(Accumulated what) const { return accumulations_.beside(what); }
  const SceneTextures& scene() const { return scene_; }
  const std::string& traversal() const { return traversal_; }  // the one in use
  const RayCensus& census() const { return census_; }
  double compileSeconds() const { return compile_seconds_; }

 private:
  // One pass of a sample. After the last bounce there may be one more, on which only what leaves
  // a surface in a sharp direction is followed.
  struct Stage {
    Pass pass;
    int bounce;
  };

  gl::Tile whole() const { return {0, 0, film_.width(), film_.height()}; }
  void drawFirstRays(std::uint32_t sample);
  bool drawDeltaRays(const Stage& stage, std::uint32_t sample);

  // Programs are kept by what they are composed from: the traversal in them, none for those without
  // one, the pass, and the effects that it may depend on.
  using ProgramKey = std::tuple<std::string, Pass, unsigned long>;
  ProgramKey keyOf(Pass pass) const;
  gl::Program& program(Pass pass) { return programs_.at(keyOf(pass)); }
  void takeEffects(const Scene& scene);
  void planStages();
  void planBounce(int bounce);
  bool marksEnded(int bounce) const;
  ShaderRequest requestFor(Pass pass) const;
  void compile(const WorkProgress& progress);
  void compilePass(Pass pass);
  gl::Tile nextTile(double pixels) const;
  void beginStage(const Stage& stage);
  void beginSample();
  void drawStage(const Stage& stage, const gl::Tile& tile);
  void endStage(const Stage& stage);
  bool asksWhetherAlive(const Stage& stage) const;
  static bool isOfCamera(const Stage& stage);
  void drawRays(const gl::Tile& tile, const gl::DrawState& state);
  std::size_t stageAfter() const;
  void bindSamplePoint(gl::Program& program, const Stage& stage, std::uint32_t sample) const;
  void bindPath(gl::Program& program, const Stage& stage, std::uint32_t sample) const;

  const gl::Device* device_;
  SamplePoints points_;
  std::vector<std::string> candidates_;
  std::string traversal_;
  Record record_;
  std::uint32_t first_sample_;
  bool path_lengths_;
  SceneTextures scene_;
  gl::Texture offsets_;
  EffectChange change_;
  EffectSet effects_;
  int bounces_;
  bool roulette_;
  bool live_only_;
  std::vector<gl::Tile> resting_;
  std::map<ProgramKey, gl::Program> programs_;
  std::vector<Stage> stages_;
  Film film_;
  Accumulations accumulations_;
  Camera camera_;
  RayCensus census_;
  gl::Query query_;
  double compile_seconds_ = 0;

  // Where the work stands.
  int samples_ = 0;
  std::size_t stage_ = 0;
  int row_ = 0;  // of the stage, the first pixel that is not drawn yet
  int column_ = 0;
  bool alive_now_ = true;  // whether any path of the sample may be, as far as is known
};

}  // namespace glimt
