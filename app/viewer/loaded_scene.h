// A scene with its tree, as it is on disk.
#pragma once

#include <filesystem>

#include "renderer/core/work_progress.h"
#include "renderer/renderer.h"
#include "renderer/scene/load_scene.h"

namespace glimt {

// What is opened, and how.
struct SceneChoice {
  std::filesystem::path path;
  LoadSettings settings;
};

struct LoadedScene {
  SceneChoice choice;
  Scene scene;
  Tree tree;
  double load_seconds = 0;
  std::filesystem::file_time_type written;  // when the file was, that is now what is here
};

// On any thread. Triangles that lie as they do in `before`, which may be null, take its tree.
// Errors: input and usage, as loadScene() and Tree.
LoadedScene loadWithTree(const SceneChoice& choice, const LoadedScene* before,
                         const WorkProgress& progress);

// When the file was written; the beginning of time where it is not there.
std::filesystem::file_time_type writtenAt(const std::filesystem::path& path);

}  // namespace glimt
