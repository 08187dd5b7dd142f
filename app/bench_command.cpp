#include <cstdlib>

#include "app/bench_chart.h"
#include "app/bench_report.h"
#include "app/commands.h"
#include "app/device_report.h"
#include "app/json_output.h"
#include "app/output_files.h"
#include "app/progress.h"
#include "renderer/bench/bench_mesh.h"
#include "renderer/core/error.h"
#include "renderer/core/file.h"
#include "renderer/scene/load_scene.h"

namespace glimt {
namespace {

constexpr int kQuickRepeats = 5;

TraversalBenchSettings traversalSettings(const BenchOptions& options) {
  TraversalBenchSettings settings;
  settings.side = options.side;
  if (options.quick) {
    settings.triangles.resize(2);
    settings.repeats = kQuickRepeats;
  }
  if (!options.triangles.empty()) settings.triangles = options.triangles;
  return settings;
}

PassesBenchSettings passesSettings(const BenchOptions& options) {
  PassesBenchSettings settings;
  settings.side = options.side;
  if (options.quick) {
    settings.bounces = {1, 2, 4, 8};
    settings.repeats = kQuickRepeats;
  }
  if (!options.triangles.empty()) settings.triangles = options.triangles;
  if (!options.bounces.empty()) settings.bounces = options.bounces;
  return settings;
}

// Mesa keeps compiled shaders on disk: the times to compile would be those of reading a file. Other
// drivers ignore this, and whoever has set it keeps what is set.
void doWithoutShaderCache() {
  setenv("MESA_SHADER_CACHE_DISABLE", "true", 0);
}

EffectsBenchSettings effectsSettings(const BenchOptions& options, const Scene& scene) {
  EffectsBenchSettings settings;
  settings.side = options.side;
  if (options.quick) {
    settings.repeats = kQuickRepeats;
    settings.compile_repeats = 1;
  }
  settings.bounces = options.bounces.empty() ? settingsOf(PictureOptions(), scene).bounces
                                             : options.bounces.front();
  return settings;
}

DeviceBenchSettings deviceSettings(const BenchOptions& options) {
  DeviceBenchSettings settings;
  settings.ray_side = options.side;
  if (options.quick) {
    settings.sides.resize(1);
    settings.repeats = kQuickRepeats;
  }
  if (!options.triangles.empty()) settings.triangles = options.triangles.front();
  return settings;
}

void writeResults(const DeviceBench& bench, const BenchOptions& options,
                  const ContextInfo& context) {
  if (options.json != "-") writeOut(textOf(bench, context));
  writeJson(options.json, jsonOf(bench, context));
}

template <typename Row>
void writeResults(const std::vector<Row>& rows, const BenchOptions& options,
                  const ContextInfo& context) {
  const BenchConditions conditions{context, options.side};
  // The table would spoil a report on the same output.
  if (options.json != "-") writeOut(textOf(rows, conditions));
  writeJson(options.json, jsonOf(rows, conditions));
  if (!options.chart.empty()) writeFile(options.chart, chartOf(rows, conditions));
}

}  // namespace

int runBench(const BenchOptions& options) {
  checkJsonFile(options.json);
  if (!options.chart.empty()) {
    if (options.suite == BenchSuite::device)
      throw Error(ErrorKind::usage, "--suite device has no chart; leave --chart out");
    checkWritable(options.chart);
  }
  if (!options.scene.empty() && options.suite != BenchSuite::effects)
    throw Error(ErrorKind::usage, "SCENE is for --suite effects; the other suites bring their own");
  doWithoutShaderCache();
  ContextHandle context = createOffscreenContext(options.backend, options.gles);
  Progress progress(true);
  const auto show = [&](const std::string& what) { progress.show(what); };
  if (options.suite == BenchSuite::device) {
    const DeviceBench bench = benchDevice(context, deviceSettings(options), show);
    progress.clear();
    writeResults(bench, options, context.info());
  } else if (options.suite == BenchSuite::passes) {
    const auto rows = benchPasses(context, passesSettings(options), show);
    progress.clear();
    writeResults(rows, options, context.info());
  } else if (options.suite == BenchSuite::effects) {
    const Scene scene = options.scene.empty() ? makeBenchBox() : loadScene(options.scene, {});
    const auto rows =
        benchEffects(context, scene, Tree(scene), effectsSettings(options, scene), show);
    progress.clear();
    writeResults(rows, options, context.info());
  } else {
    const auto rows = benchTraversals(context, traversalSettings(options), show);
    progress.clear();
    writeResults(rows, options, context.info());
  }
  return 0;
}

}  // namespace glimt
