// What the viewer reads and writes.
#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <utility>

#include "app/message.h"
#include "app/viewer/edited_scene.h"
#include "app/viewer/reloaded_look.h"
#include "app/viewer/render_command_line.h"
#include "app/viewer/snapshot_name.h"
#include "app/viewer/viewer.h"
#include "renderer/core/error.h"
#include "renderer/core/file.h"
#include "renderer/core/image_file.h"
#include "renderer/core/wording.h"
#include "renderer/scene/framing.h"

namespace glimt {
namespace {

constexpr double kWatchSeconds = 0.5;
constexpr std::size_t kMostRecent = 6;
constexpr int kCommandSamples = 256;

// A file that is being written grows: it is read once it is left alone.
constexpr auto kSettled = std::chrono::milliseconds(300);

}  // namespace

void Viewer::load(const SceneChoice& choice) {
  loading_.reset();  // what was under way is given up
  loading_choice_ = choice;
  const std::shared_ptr<const LoadedScene> before = scene_;
  loading_ = std::make_unique<BackgroundTask<LoadedScene>>(
      [choice, before](const WorkProgress& progress) {
        return loadWithTree(choice, before.get(), progress);
      },
      Window::wake);
  frames_wanted_ = 3;
}

void Viewer::takeScene() {
  if (!loading_ || !loading_->done()) return;
  const auto task = std::move(loading_);
  try {
    if (std::optional<LoadedScene> loaded = task->take())
      show(std::make_shared<const LoadedScene>(std::move(*loaded)));
    else
      tell("not opened; the scene is as before");
  } catch (const Error& error) {
    if (!scene_) throw;
    tell(error.what(), true);
    // A variant that could not be read is not what is shown.
    state_.look.variant = scene_->choice.settings.variant;
  }
}

void Viewer::show(std::shared_ptr<const LoadedScene> loaded) {
  const Scene& scene = loaded->scene;
  const Look look =
      lookOf(scene, loaded->choice.settings.variant, settingsOf(options_, scene).bounces,
             exposureOf(options_, scene), toneOf(options_, scene));
  if (scene_ && scene_->choice.path == loaded->choice.path) {
    const bool same_materials = look.materials.size() == state_.look.materials.size();
    if (!same_materials) state_.material.reset();
    state_.look = reloadedLook(state_.look, file_look_, look);
    const std::string saved_variant = saved_look_.variant;
    saved_look_ = reloadedLook(saved_look_, file_look_, look);
    saved_look_.variant = saved_variant;
    if (!same_materials) history_.emplace(state_.look);
  } else {
    // The command line speaks of the first scene's camera.
    const Camera camera = scene_ ? scene.camera : cameraOf(options_.camera, scene);
    camera_ = OrbitCamera(withTargetAtModel(camera, boundsOf(scene)));
    state_.look = look;
    saved_look_ = look;
    state_.material.reset();
    history_.emplace(look);
    beside_.reset();
    saved_scene_.clear();
    remember(*loaded);
  }
  file_look_ = look;
  scene_ = std::move(loaded);
  noise_.clear();
  asked_ = true;
  frames_wanted_ = 3;
}

// What was opened, and what there is to say about it.
void Viewer::remember(const LoadedScene& loaded) {
  for (const std::string& warning : loaded.scene.warnings) say("warning: " + warning);
  std::erase(recent_, loaded.choice.path);
  recent_.insert(recent_.begin(), loaded.choice.path);
  if (recent_.size() > kMostRecent) recent_.pop_back();
}

void Viewer::watchFile() {
  if (!scene_ || loading_ || since_watch_.seconds() < kWatchSeconds) return;
  since_watch_ = {};
  const auto written = writtenAt(scene_->choice.path);
  const bool there = written != std::filesystem::file_time_type();
  if (!there || written == scene_->written || written == refused_) return;
  if (std::filesystem::file_time_type::clock::now() - written < kSettled) return;
  refused_ = written;
  load(scene_->choice);
}

void Viewer::saveScene() {
  if (!scene_) return;
  try {
    const EditedScene edited = editedScene(*scene_, state_.look, camera_.camera(), request_.size);
    if (saved_scene_.empty()) saved_scene_ = editedSceneName(scene_->choice.path);
    writeFile(saved_scene_, edited.file.dump(2) + "\n");
    saved_look_ = state_.look;
    std::string text = fmt::format("saved {}", saved_scene_.string());
    for (const std::string& warning : edited.warnings) text += "; " + warning;
    tell(text, !edited.warnings.empty());
  } catch (const Error& error) {
    tell(error.what(), true);
  }
}

// What the command line cannot say is said in a scene file.
void Viewer::copyCommand() {
  if (!scene_) return;
  std::string line;
  const int samples = std::max(status_.samples, kCommandSamples);
  if (fitsCommandLine(*scene_, state_.look, camera_.camera())) {
    line = renderCommandLine(*scene_, state_.look, camera_.camera(), request_.size, samples);
  } else {
    saveScene();
    if (saved_scene_.empty()) return;
    line = renderCommandLine(saved_scene_, samples);
  }
  glfwSetClipboardString(window_.get(), line.c_str());
  tell("copied: " + line);
}

}  // namespace glimt
