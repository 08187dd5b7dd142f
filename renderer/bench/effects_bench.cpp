#include <fmt/format.h>

#include <memory>

#include "renderer/bench.h"
#include "renderer/bench/picture_comparison.h"
#include "renderer/bench/stopwatch.h"
#include "renderer/bench/whole_sample.h"
#include "renderer/core/error.h"
#include "renderer/core/wording.h"
#include "renderer/scene/effects_of.h"

namespace glimt {
namespace {

// Of the picture that is drawn once before the time counts: some drivers leave most of the
// compilation to the first draw. Large enough that paths end as they do in others.
constexpr int kFirstSide = 16;

std::vector<std::string> namesOf(const EffectSet& effects) {
  std::vector<std::string> names;
  for (int i = 0; i < kEffectCount; ++i)
    if (effects[static_cast<std::size_t>(i)]) names.push_back(nameOf(static_cast<Effect>(i)));
  return names;
}

// The scene's own effects with some forced upon them, or without some.
struct Candidate {
  EffectsRow row;
  EffectChange change;
  std::unique_ptr<PathTracer> tracer;  // none: the driver refuses one of its shaders
  std::vector<double> compile_seconds;
  std::vector<double> sample_seconds;
  PictureComparison comparison;  // with the scene's own alone
};

class EffectsBench {
 public:
  using Progress = std::function<void(const std::string&)>;

  EffectsBench(const gl::Device& device, const Scene& scene, const SceneTree& tree,
               const EffectsBenchSettings& settings, const Progress& progress)
      : device_(&device),
        scene_(&scene),
        settings_(&settings),
        progress_(&progress),
        tree_(&tree),
        own_(effectsOf(scene)) {
    addCandidates();
  }

  // Repeats go round the candidates, so that a slow moment of the machine is not one candidate's.
  std::vector<EffectsRow> run() {
    for (int repeat = 1; repeat <= settings_->compile_repeats; ++repeat)
      for (Candidate& candidate : candidates_) {
        (*progress_)(fmt::format("compiling, {} of {}: {}", repeat, settings_->compile_repeats,
                                 candidate.row.effect));
        compile(candidate);
      }
    for (Candidate& candidate : candidates_)
      if (candidate.tracer) candidate.tracer->resize(settings_->side, settings_->side);
    for (int repeat = 0; repeat <= settings_->repeats; ++repeat) {
      (*progress_)(fmt::format("sample {} of {}", repeat, settings_->repeats));
      drawRound(repeat > 0);
    }
    std::vector<EffectsRow> rows;
    for (const Candidate& candidate : candidates_) rows.push_back(rowOf(candidate));
    return rows;
  }

 private:
  void addCandidates() {
    add(kOwnEffects, {});
    const EffectSet withheld = changeable(own_);
    for (int i = 0; i < kEffectCount; ++i) {
      const EffectSet one = EffectSet().set(static_cast<std::size_t>(i));
      if ((withheld & one).any()) add(kWithheld + nameOf(static_cast<Effect>(i)), {{}, one});
    }
    if (!settings_->forced) return;
    for (int i = 0; i < kEffectCount; ++i) {
      const EffectChange change{EffectSet().set(static_cast<std::size_t>(i)), {}};
      if (changed(own_, change) != own_) add(nameOf(static_cast<Effect>(i)), change);
    }
    add(kAllEffects, {EffectSet().set(), {}});
  }

  void add(const std::string& effect, const EffectChange& change) {
    Candidate& candidate = candidates_.emplace_back();
    candidate.change = change;
    candidate.row.scene = scene_->name;
    candidate.row.triangles = scene_->triangles.size();
    candidate.row.bounces = settings_->bounces;
    candidate.row.effect = effect;
    candidate.row.forced = namesOf(changed(own_, change) & ~own_);
    candidate.row.withheld = namesOf(own_ & ~changed(own_, change));
  }

  void compile(Candidate& candidate) {
    PathTracerSettings path;
    path.bounces = settings_->bounces;
    path.change = candidate.change;
    try {
      candidate.tracer = std::make_unique<PathTracer>(*device_, *scene_, path, *tree_);
    } catch (const Error& error) {
      if (error.kind() != ErrorKind::failed || candidate.row.effect == kOwnEffects) throw;
      candidate.row.note = error.what();
      return;
    }
    candidate.row.traversal = candidate.tracer->traversal();
    candidate.tracer->resize(kFirstSide, kFirstSide);
    candidate.compile_seconds.push_back(candidate.tracer->compileSeconds() +
                                        drawSeconds(*candidate.tracer));
  }

  double drawSeconds(PathTracer& tracer) const {
    return secondsOf(*device_, [&tracer] { drawSample(tracer); });
  }

  void drawRound(bool timed) {
    std::vector<Vec4> reference;
    for (Candidate& candidate : candidates_) {
      if (!candidate.tracer) continue;
      const double seconds = drawSeconds(*candidate.tracer);
      if (timed) candidate.sample_seconds.push_back(seconds);
      const std::vector<Vec4> radiance = candidate.tracer->film().radiance.front().readFloats();
      if (reference.empty()) reference = radiance;
      candidate.comparison.add(radiance, reference);
    }
  }

  std::vector<double> ratiosOf(const Candidate& candidate) const {
    const std::vector<double>& own = candidates_.front().sample_seconds;
    std::vector<double> ratios;
    for (std::size_t i = 0; i < own.size(); ++i)
      ratios.push_back(candidate.sample_seconds[i] / own[i]);
    return ratios;
  }

  EffectsRow rowOf(const Candidate& candidate) const {
    EffectsRow row = candidate.row;
    if (!candidate.tracer) return row;
    row.compile_seconds = spreadOf(candidate.compile_seconds);
    row.sample_seconds = spreadOf(candidate.sample_seconds);
    row.ratio = spreadOf(ratiosOf(candidate));
    if (row.withheld.empty()) row.agrees = candidate.comparison.agrees();
    const std::size_t lost = candidate.comparison.lost();
    if (lost > 0) row.note = fmt::format("{} cut short or not finite", counted(lost, "path"));
    return row;
  }

  const gl::Device* device_;
  const Scene* scene_;
  const EffectsBenchSettings* settings_;
  const Progress* progress_;
  const SceneTree* tree_;
  EffectSet own_;
  std::vector<Candidate> candidates_;  // the first is that of the scene's own effects alone
};

}  // namespace

std::vector<EffectsRow> benchEffects(ContextHandle& context, const Scene& scene, const Tree& tree,
                                     const EffectsBenchSettings& settings,
                                     const std::function<void(const std::string&)>& progress) {
  const gl::Device device(context.get());
  return EffectsBench(device, scene, tree.get(), settings, progress).run();
}

}  // namespace glimt
