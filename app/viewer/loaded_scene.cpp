#include "app/viewer/loaded_scene.h"

#include <algorithm>
#include <system_error>
#include <utility>

#include "app/stopwatch.h"

namespace glimt {
namespace {

// Reading a file takes about as long as this share of the whole.
constexpr float kReading = 0.3f;

bool sameTriangles(const Scene& a, const Scene& b) {
  return a.positions == b.positions &&
         std::equal(
             a.triangles.begin(), a.triangles.end(), b.triangles.begin(), b.triangles.end(),
             [](const Triangle& s, const Triangle& t) { return s.positions == t.positions; });
}

}  // namespace

LoadedScene loadWithTree(const SceneChoice& choice, const LoadedScene* before,
                         const WorkProgress& progress) {
  const Stopwatch clock;
  const auto written = writtenAt(choice.path);
  progress(0);
  Scene scene = loadScene(choice.path, choice.settings);
  progress(kReading);
  Tree tree = before != nullptr && sameTriangles(before->scene, scene)
                  ? before->tree
                  : Tree(scene, partOf(progress, kReading, 1));
  return {choice, std::move(scene), std::move(tree), clock.seconds(), written};
}

std::filesystem::file_time_type writtenAt(const std::filesystem::path& path) {
  std::error_code error;
  const auto time = std::filesystem::last_write_time(path, error);
  return error ? std::filesystem::file_time_type() : time;
}

}  // namespace glimt
