// What the viewer reads, writes, and has worked on beside the window.
#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <utility>

#include "app/message.h"
#include "app/viewer/beside_work.h"
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
constexpr double kRestSeconds = 0.3;
constexpr std::size_t kMostRecent = 6;
constexpr int kOutlineDivisor = 2;
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
  effects_ = reportEffects(scene_->scene);
  limits_.reset();
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

void Viewer::takeOutline() {
  if (outline_wanted_ && !state_.material) {
    outline_wanted_ = false;
    canvas_.hideOutline();
  }
  if (outline_wanted_ && scene_ && since_change_.seconds() > kRestSeconds) {
    outline_wanted_ = false;
    outlining_ = std::make_unique<BackgroundTask<Outline>>(
        [scene = scene_, camera = camera_.camera(), material = *state_.material,
         size = request_.size](const WorkProgress& progress) {
          return outlineOf(*scene, camera, material, std::max(size[0] / kOutlineDivisor, 1),
                           std::max(size[1] / kOutlineDivisor, 1), progress);
        },
        Window::wake);
  }
  if (outline_wanted_ && outlining_) outlining_->cancel();
  if (!outlining_ || !outlining_->done()) return;
  const auto task = std::move(outlining_);
  const std::optional<Outline> outline = task->take();
  if (!outline || outline_wanted_ || !state_.material) return;
  canvas_.setOutline(*outline);
  frames_wanted_ = std::max(frames_wanted_, 1);
}

void Viewer::takeFinished() {
  try {
    if (measuring_ && measuring_->done()) limits_ = std::exchange(measuring_, nullptr)->take();
    if (saving_ && saving_->done())
      tell(std::exchange(saving_, nullptr)->take().value_or("no picture was written"));
  } catch (const Error& error) {
    tell(error.what(), true);
  }
}

BesidePicture Viewer::besidePicture(std::array<int, 2> size) const {
  RenderSettings settings = settingsOf(options_, scene_->scene);
  settings.width = size[0];
  settings.height = size[1];
  return {{scene_, state_.look}, camera_.camera(), settings, options_.gles};
}

void Viewer::measureLimits() {
  if (!scene_ || !status_.noise || measuring_) return;
  measuring_ = std::make_unique<BackgroundTask<LimitError>>(
      [picture = besidePicture(request_.size), noise = status_.noise->relative](
          const WorkProgress& progress) { return measureLimitsOf(picture, noise, progress); },
      Window::wake);
}

void Viewer::savePicture(const SavedPicture& picture) {
  constexpr int kLargestSide = 16384;
  const auto fits = [](int side) { return side >= 1 && side <= kLargestSide; };
  if (!scene_ || saving_) return;
  if (!fits(picture.size[0]) || !fits(picture.size[1]) || picture.samples < 1)
    return tell("a picture has 1 to 16384 pixels a side and at least one sample", true);
  try {
    imageFormatOf(picture.file);
  } catch (const Error& error) {
    return tell(error.what(), true);
  }
  saving_ = std::make_unique<BackgroundTask<std::string>>(
      [work = besidePicture(picture.size), picture](const WorkProgress& progress) {
        renderToFile(work, picture.samples, picture.file, progress);
        return fmt::format("rendered {}, {}", picture.file.string(),
                           counted(static_cast<std::uintmax_t>(picture.samples), "sample"));
      },
      Window::wake);
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
