#include <fmt/format.h>

#include <cmath>

#include "app/commands.h"
#include "app/json_output.h"
#include "app/viewer/default_scene.h"
#include "app/viewer/viewer.h"
#include "app/viewer/window.h"
#include "renderer/core/error.h"
#include "renderer/core/wording.h"

namespace glimt {
namespace {

constexpr std::array<int, 2> kWindow{1280, 720};

Json spreadOf(const std::vector<double>& seconds) {
  const auto milliseconds = [&](double share) {
    return std::round(1e4 * quantile(seconds, share)) / 10;
  };
  return {{"count", seconds.size()},
          {"median", milliseconds(0.5)},
          {"p95", milliseconds(0.95)},
          {"max", milliseconds(1)}};
}

// How the window answered.
Json reportOf(const Pace& pace) {
  return {{"latency_ms", spreadOf(pace.latencies())}, {"frame_ms", spreadOf(pace.intervals())}};
}

// Before a window is opened for it.
void demandFile(const std::filesystem::path& path) {
  std::error_code ignored;
  if (std::filesystem::exists(path, ignored)) return;
  throw Error(ErrorKind::input,
              fmt::format("{}: no such file; check the path", printable(path.string())));
}

}  // namespace

int runView(const ViewOptions& options) {
  const std::filesystem::path scene = options.scene ? *options.scene : defaultScene();
  demandFile(scene);
  checkJsonFile(options.json);
  const bool scaled = !options.picture.size.has_value();
  Window window(options.picture.size.value_or(kWindow), scaled, "glimt");
  Viewer viewer(window, options.picture);
  viewer.run({scene, {options.load.variant, options.picture.environment}});
  writeJson(options.json, reportOf(viewer.pace()));
  return 0;
}

}  // namespace glimt
