#include <cstdlib>

#include "app/bench_report.h"
#include "app/commands.h"
#include "app/device_report.h"
#include "app/json_output.h"
#include "app/progress.h"

namespace glimt {
namespace {

constexpr int kQuickRepeats = 5;

TraversalBenchSettings settingsOf(const BenchOptions& options) {
  TraversalBenchSettings settings;
  if (options.quick) {
    settings.triangles.resize(2);
    settings.repeats = kQuickRepeats;
  }
  if (!options.triangles.empty()) settings.triangles = options.triangles;
  return settings;
}

// Mesa keeps compiled shaders on disk: the times to compile would be those of reading a file. Other
// drivers ignore this, and whoever has set it keeps what is set.
void doWithoutShaderCache() {
  setenv("MESA_SHADER_CACHE_DISABLE", "true", 0);
}

DeviceBenchSettings deviceSettingsOf(const BenchOptions& options) {
  DeviceBenchSettings settings;
  if (options.quick) {
    settings.sides.resize(1);
    settings.repeats = kQuickRepeats;
  }
  if (!options.triangles.empty()) settings.triangles = options.triangles.front();
  return settings;
}

int runDeviceBench(const BenchOptions& options, ContextHandle& context) {
  Progress progress(true);
  const DeviceBench bench = benchDevice(context, deviceSettingsOf(options),
                                        [&](const std::string& what) { progress.show(what); });
  progress.clear();
  if (options.json != "-") writeOut(textOf(bench, context.info()));
  writeJson(options.json, jsonOf(bench, context.info()));
  return 0;
}

}  // namespace

int runBench(const BenchOptions& options) {
  checkJsonFile(options.json);
  doWithoutShaderCache();
  ContextHandle context = createOffscreenContext(options.backend, options.gles);
  if (options.suite == "device") return runDeviceBench(options, context);
  Progress progress(true);
  const std::vector<TraversalRow> rows = benchTraversals(
      context, settingsOf(options), [&](const std::string& what) { progress.show(what); });
  progress.clear();
  // The table would spoil a report on the same output.
  if (options.json != "-") writeOut(textOf(rows, context.info()));
  writeJson(options.json, jsonOf(rows, context.info()));
  return 0;
}

}  // namespace glimt
