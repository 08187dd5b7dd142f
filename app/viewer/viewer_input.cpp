// What the user's hand does.
#include <cmath>

#include "app/viewer/snapshot_name.h"
#include "app/viewer/viewer.h"
#include "renderer/core/error.h"
#include "renderer/pick.h"
#include "renderer/scene/framing.h"

namespace glimt {
namespace {

// Pixels beside the divider that still are it.
constexpr float kDividerReach = 8;

}  // namespace

void Viewer::orbit(Vec2 drag) noexcept {
  camera_.orbit(drag);
  asked_ = true;
}

void Viewer::pan(Vec2 drag) noexcept {
  camera_.pan(drag);
  asked_ = true;
}

// A drag over the window's height is half a turn.
void Viewer::turnLight(Vec2 drag) noexcept {
  if (!scene_) return;
  float& rotation = state_.look.environment_rotation;
  rotation = std::remainder(rotation + 180 * drag.x, 360.0f);
  asked_ = true;
}

void Viewer::zoom(float steps, Vec2 at) noexcept {
  camera_.zoomTowards(pointAt(at).value_or(camera_.camera().target), steps);
  asked_ = true;
}

std::optional<Vec3> Viewer::pointAt(Vec2 at) const {
  if (!scene_) return {};
  const Ray ray = rayThrough(camera_.camera(), inPicture(at), aspect());
  const std::optional<Pick> hit = pick(scene_->scene, scene_->tree, ray);
  if (!hit) return {};
  return ray.origin + hit->distance * ray.direction;
}

void Viewer::click(Vec2 at) noexcept {
  if (!scene_) return;
  const Ray ray = rayThrough(camera_.camera(), inPicture(at), aspect());
  const std::optional<Pick> hit = pick(scene_->scene, scene_->tree, ray);
  state_.material.reset();
  if (hit) state_.material = scene_->scene.triangles[hit->triangle].material;
  outline_wanted_ = true;
  canvas_.hideOutline();
}

void Viewer::doubleClick(Vec2 at) noexcept {
  const std::optional<Vec3> point = pointAt(at);
  if (!point) return;
  camera_.lookAt(*point);
  asked_ = true;
}

bool Viewer::covered(Vec2 at) noexcept {
  const auto width = static_cast<float>(window_.size()[0]);
  const float from_divider = (inPicture(at).x - state_.divider) * (1 - pictureLeft()) * width;
  if (canvas_.comparing() && std::abs(from_divider) < kDividerReach) {
    dragging_divider_ = true;
    return true;
  }
  if (state_.panel && at.x * width < panelWidth(width)) return true;
  return ImGui::GetIO().WantCaptureMouse;
}

void Viewer::open(const std::filesystem::path& dropped) noexcept {
  const std::string extension = dropped.extension().string();
  if (scene_ && (extension == ".hdr" || extension == ".exr"))
    return chooseEnvironment(dropped.string());
  load({dropped, {"", options_.environment}});
}

void Viewer::press(const KeyPress& key) noexcept {
  if (gui_.wantsKeys()) return;
  if (key.control)
    pressControl(key.key);
  else
    pressPlain(key);
}

void Viewer::pressControl(Key key) {
  if (key == Key::s) saveScene();
  if (key == Key::c) copyCommand();
  if (key == Key::z && history_) step(history_->undo());
  if (key == Key::y && history_) step(history_->redo());
  if (key == Key::o) {
    state_.panel = true;
    fields_.typing_path = true;
  }
}

void Viewer::pressPlain(const KeyPress& key) {
  switch (key.key) {
    case Key::escape:
      if (state_.help)
        state_.help = false;
      else
        window_.close();
      break;
    case Key::tab:
      state_.panel = !state_.panel;
      break;
    case Key::f1:
      state_.help = !state_.help;
      break;
    case Key::space:
    case Key::t:
      state_.turntable = !state_.turntable;
      break;
    case Key::c:
      compare();
      break;
    case Key::f:
      frame();
      break;
    case Key::r:
      camera_.reset();
      asked_ = true;
      break;
    case Key::s:
      if (scene_) snapshot_ = snapshotName(scene_->scene.name);
      break;
    case Key::digit:
      chooseCamera(static_cast<std::size_t>(key.digit) - 1);
      break;
    default:
      break;
  }
}

void Viewer::chooseCamera(std::size_t index) {
  if (!scene_ || index >= scene_->scene.cameras.size()) return;
  camera_ =
      OrbitCamera(withTargetAtModel(scene_->scene.cameras[index].camera, boundsOf(scene_->scene)));
  asked_ = true;
}

// One that is not the file's has nothing of the old one.
void Viewer::chooseEnvironment(const std::string& name) {
  if (!scene_) return;
  SceneChoice choice = scene_->choice;
  choice.settings.variant = state_.look.variant;
  choice.settings.environment = {};
  if (!name.empty()) choice.settings.environment.image = name;
  load(choice);
}

// What is selected, or everything.
void Viewer::frame() {
  if (!scene_) return;
  const Scene& scene = scene_->scene;
  Bounds box;
  for (const Triangle& triangle : scene.triangles)
    if (!state_.material || triangle.material == *state_.material)
      for (const std::uint32_t corner : triangle.positions) box.include(scene.positions[corner]);
  if (box.empty()) return;
  camera_.frame(box, aspect());
  asked_ = true;
}

// Another look, from the history.
void Viewer::step(const Look& look) {
  state_.look = look;
  asked_ = true;
  frames_wanted_ = 3;
  if (scene_ && look.variant != scene_->choice.settings.variant)
    load({scene_->choice.path, {look.variant, scene_->choice.settings.environment}});
}

void Viewer::chooseVariant(const std::string& variant) {
  state_.look.variant = variant;
  if (history_) history_->keep(state_.look);
  step(Look(state_.look));
}

void Viewer::compare() {
  if (!scene_) return;
  if (beside_)
    beside_.reset();
  else
    beside_ = View{scene_, state_.look};
  asked_ = true;
}

}  // namespace glimt
