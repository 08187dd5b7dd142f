#include <fmt/format.h>

#include <algorithm>
#include <memory>

#include "renderer/bench.h"
#include "renderer/bench/bench_mesh.h"
#include "renderer/bench/picture_comparison.h"
#include "renderer/bench/stopwatch.h"
#include "renderer/bench/whole_path.h"
#include "renderer/bench/whole_sample.h"
#include "renderer/core/error.h"
#include "renderer/core/wording.h"

namespace glimt {
namespace {

using Progress = std::function<void(const std::string&)>;

// One way to trace the bounces, ready to draw.
struct Candidate {
  std::function<void(int side)> resize;
  std::function<void()> draw_sample;
  std::function<std::vector<Vec4>()> read_radiance;  // of the last sample
};

Candidate candidateOf(const std::shared_ptr<PathTracer>& tracer) {
  return {[tracer](int side) { tracer->resize(side, side); }, [tracer] { drawSample(*tracer); },
          [tracer] { return tracer->film().radiance.front().readFloats(); }};
}

Candidate candidateOf(const std::shared_ptr<WholePathTracer>& tracer) {
  return {[tracer](int side) { tracer->resize(side, side); }, [tracer] { tracer->drawSample(); },
          [tracer] { return tracer->readRadiance(); }};
}

// The ways to trace one scene with one number of bounces.
class BounceBench {
 public:
  BounceBench(const gl::Device& device, const Scene& scene, const SceneTree& tree, int bounces,
              const PassesBenchSettings& settings)
      : device_(&device), scene_(&scene), settings_(&settings) {
    path_.bounces = bounces;
    path_.roulette = false;  // the same rays in all ways
    addPasses(tree);
    addWholePath(kLoop, PathForm::loop);
    addWholePath(kUnrolled, PathForm::unrolled);
  }

  // Repeats go round the candidates, so that a slow moment of the machine is not one candidate's.
  std::vector<PassesRow> run() {
    for (int repeat = 0; repeat <= settings_->repeats; ++repeat) {
      for (Measured& measured : measured_) {
        const double seconds = secondsOf(*device_, measured.candidate.draw_sample);
        if (repeat > 0) measured.seconds.push_back(seconds);
      }
      const std::vector<Vec4> reference = measured_.front().candidate.read_radiance();
      for (Measured& measured : measured_)
        measured.comparison.add(measured.candidate.read_radiance(), reference);
    }
    for (const Measured& measured : measured_) finishRow(measured);
    return rows_;
  }

 private:
  struct Measured {
    std::size_t row;
    Candidate candidate;
    std::vector<double> seconds;
    PictureComparison comparison;  // with the passes
  };

  void addPasses(const SceneTree& tree) {
    tracer_ = std::make_shared<PathTracer>(*device_, *scene_, path_, tree);
    path_.traversal = tracer_->traversal();
    addRow(kPasses);
    addCandidate(candidateOf(tracer_), tracer_->compileSeconds());
  }

  void addWholePath(const std::string& variant, PathForm form) {
    addRow(variant);
    try {
      std::shared_ptr<WholePathTracer> tracer;
      const double seconds = secondsOf(*device_, [&] {
        tracer =
            std::make_shared<WholePathTracer>(*device_, *scene_, tracer_->scene(), path_, form);
      });
      addCandidate(candidateOf(tracer), seconds);
    } catch (const Error& error) {
      if (error.kind() != ErrorKind::failed) throw;
      rows_.back().note = error.what();
    }
  }

  void addRow(const std::string& variant) {
    rows_.push_back({scene_->name,
                     scene_->triangles.size(),
                     path_.bounces,
                     variant,
                     path_.traversal,
                     {},
                     {},
                     {},
                     {}});
  }

  // Some drivers leave most of the compilation to the first draw, so a picture of one pixel is
  // drawn.
  void addCandidate(const Candidate& candidate, double compile_seconds) {
    candidate.resize(1);
    rows_.back().compile_seconds = compile_seconds + secondsOf(*device_, candidate.draw_sample);
    candidate.resize(settings_->side);
    measured_.push_back({rows_.size() - 1, candidate, {}, {}});
  }

  void finishRow(const Measured& measured) {
    PassesRow& row = rows_[measured.row];
    row.sample_seconds = spreadOf(measured.seconds);
    row.agrees = measured.comparison.agrees();
    const std::size_t lost = measured.comparison.lost();
    if (lost > 0) row.note = fmt::format("{} cut short or not finite", counted(lost, "path"));
  }

  const gl::Device* device_;
  const Scene* scene_;
  const PassesBenchSettings* settings_;
  PathTracerSettings path_;
  std::shared_ptr<PathTracer> tracer_;
  std::vector<PassesRow> rows_;
  std::vector<Measured> measured_;  // without those that the driver refuses
};

std::vector<PassesRow> benchScene(const gl::Device& device, const Scene& scene,
                                  const PassesBenchSettings& settings, const Progress& progress) {
  const SceneTree tree = buildSceneTree(scene, device.maxTextureSize());
  std::vector<PassesRow> rows;
  for (const int bounces : settings.bounces) {
    progress(fmt::format("{}, {}: {}", scene.name, counted(scene.triangles.size(), "triangle"),
                         counted(static_cast<std::uintmax_t>(bounces), "bounce")));
    const auto more = BounceBench(device, scene, tree, bounces, settings).run();
    rows.insert(rows.end(), more.begin(), more.end());
  }
  return rows;
}

}  // namespace

std::vector<PassesRow> benchPasses(ContextHandle& context, const PassesBenchSettings& settings,
                                   const std::function<void(const std::string&)>& progress) {
  const gl::Device device(context.get());
  std::vector<Scene> scenes{makeBenchBox()};
  for (const std::size_t triangles : settings.triangles) scenes.push_back(makeBenchMesh(triangles));
  std::vector<PassesRow> rows;
  for (const Scene& scene : scenes) {
    const auto more = benchScene(device, scene, settings, progress);
    rows.insert(rows.end(), more.begin(), more.end());
  }
  return rows;
}

}  // namespace glimt
