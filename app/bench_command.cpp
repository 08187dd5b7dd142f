#include <cstdlib>

#include "app/bench_report.h"
#include "app/commands.h"
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

}  // namespace

int runBench(const BenchOptions& options) {
  checkJsonFile(options.json);
  doWithoutShaderCache();
  ContextHandle context = createOffscreenContext(options.backend, options.gles);
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
