#include "app/viewer/viewer.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "app/message.h"
#include "renderer/core/error.h"
#include "renderer/core/wording.h"

namespace glimt {
namespace {

// Between two looks at what the threads do, where nobody does anything.
constexpr double kIdleSeconds = 0.25;
// Between two looks at a progress bar.
constexpr double kProgressSeconds = 0.1;
constexpr double kTitleSeconds = 0.25;
constexpr double kMessageSeconds = 5;
constexpr double kFailureSeconds = 15;

// Events that were there before the wait for them began came while something else was done.
constexpr double kAtOnce = 0.001;

// ImGui takes a frame to learn of an event, and another to answer it.
constexpr int kFramesOfEvent = 3;

// Seconds in which nothing changes before what takes long is begun.
constexpr double kRestSeconds = 0.3;

constexpr float kTurnsPerSecond = 1.0f / 12;

// A narrower window has more use for the picture than for the panel.
constexpr int kNarrow = 800;

RenderSettings settingsOf(const PictureOptions& options) {
  RenderSettings settings;
  settings.seed = options.seed;
  settings.traversal = options.traversal;
  settings.record = options.record;
  settings.sampler = options.sampler;
  settings.roulette = options.roulette;
  settings.clamp = options.clamp;
  return settings;
}

}  // namespace

Viewer::Viewer(Window& window, const PictureOptions& picture)
    : window_(window),
      options_(picture),
      gui_(window),
      canvas_(gui_),
      renderer_(
          settingsOf(picture),
          [gles = picture.gles] { return createOffscreenContext(Backend::automatic, gles); },
          Window::wake),
      camera_(Camera()) {
  state_.panel = window.framebufferSize()[0] >= kNarrow * window.scale();
  window_.listen(*this);
}

void Viewer::run(const SceneChoice& first) {
  load(first);
  window_.show();
  while (!window_.closing()) {
    handleEvents();
    takeResults();
    watchFile();
    turnTable();
    ask();
    if (snapshot_) renderer_.save(*std::exchange(snapshot_, std::nullopt));
    if (!window_.minimized() && frames_wanted_ > 0) {
      --frames_wanted_;
      draw();
    }
    updateTitle();
  }
  // What still runs may take a moment to notice.
  window_.hide();
}

void Viewer::handleEvents() {
  const Stopwatch waited;
  const double before = since_events_.seconds();
  event_age_ = before;
  if (frames_wanted_ > 0) {
    window_.pollEvents();
  } else {
    const bool working = loading_ || saving_ || measuring_ || costing_;
    window_.waitEvents(working ? kProgressSeconds : kIdleSeconds);
    if (working) frames_wanted_ = 1;
  }
  if (waited.seconds() > kAtOnce) event_age_ = 0;
  since_events_ = {};
  if (window_.takeActivity()) frames_wanted_ = kFramesOfEvent;
}

void Viewer::turnTable() {
  if (!state_.turntable || !scene_ || window_.minimized()) {
    since_turn_ = {};
    return;
  }
  const double seconds = since_turn_.seconds();
  if (seconds < 1.0 / 60) return;
  since_turn_ = {};
  camera_.orbit({-2 * kTurnsPerSecond * static_cast<float>(seconds), 0});
  event_age_ = 0;
  asked_ = true;
}

void Viewer::takeResults() {
  if (std::optional<PictureFrame> frame = renderer_.takeFrame()) {
    canvas_.take(*frame);
    shown_serial_ = frame->serial;
    frames_wanted_ = std::max(frames_wanted_, 1);
  }
  for (const Message& message : renderer_.takeMessages()) tell(message.text, message.failure);
  PictureStatus status = renderer_.status();
  if (status.samples != status_.samples || status.divisor != status_.divisor)
    frames_wanted_ = std::max(frames_wanted_, 1);
  status_ = std::move(status);
  if (status_.noise) noise_.add(*status_.noise);
  if (status_.divisor > 1) noise_.clear();
  takeScene();
  takeOutline();
  takeFinished();
}

void Viewer::ask() {
  const std::array<int, 2> size = pictureSize();
  const bool rest = window_.minimized();
  if (size != request_.size || rest != request_.rest) asked_ = true;
  if (!asked_) return;
  asked_ = false;
  const bool moved = !rest && scene_ != nullptr;
  const View& shown = request_.view;
  if (scene_ != shown.scene || !sameLight(state_.look, shown.look)) forgetMeasured();
  if (beside_) beside_->denoise = state_.denoise;
  request_ = {{scene_, state_.look, state_.denoise},
              beside_,
              camera_.camera(),
              size,
              rest,
              request_.serial + 1};
  if (moved) pace_.asked(request_.serial, event_age_);
  renderer_.ask(request_);
  since_change_ = {};
  outline_wanted_ = true;
  if (canvas_.hideOutline()) frames_wanted_ = std::max(frames_wanted_, 1);
}

void Viewer::draw() {
  gui_.beginFrame();
  moveDivider();
  canvas_.draw(pictureLeft(), state_.divider);
  const Look before = state_.look;
  const bool denoised = state_.denoise;
  const std::optional<std::size_t> selected = state_.material;
  PanelWishes wishes;
  if (state_.panel) {
    const PanelData data{scene_.get(),
                         camera_.camera(),
                         status_,
                         renderer_.context(),
                         options_.record,
                         noise_,
                         recent_,
                         request_.size,
                         {pace_.framesPerSecond(), pace_.lastLatency()},
                         limits_,
                         measuring_ != nullptr,
                         effect_costs_,
                         costing_ != nullptr,
                         saving_ ? std::optional(saving_->progress()) : std::nullopt,
                         beside_.has_value(),
                         history_ && history_->canUndo(),
                         history_ && history_->canRedo()};
    wishes = drawPanel(data, state_, fields_);
  }
  if (state_.help) drawHelp(state_.help);
  if (drawNotice(notice())) loading_->cancel();
  gui_.endFrame();
  if (fields_.typing_path) frames_wanted_ = kFramesOfEvent;
  if (shown_serial_) pace_.shown(*shown_serial_);
  shown_serial_.reset();

  if (state_.look != before || state_.denoise != denoised) {
    asked_ = true;
    event_age_ = since_events_.seconds();
  }
  if (state_.material != selected) outline_wanted_ = true;
  // A slider that is held is one step when it is let go.
  if (history_ && !ImGui::IsAnyItemActive()) history_->keep(state_.look);
  fulfil(wishes);
}

void Viewer::moveDivider() {
  if (!canvas_.comparing() || !dragging_divider_) return;
  const ImGuiIO& io = ImGui::GetIO();
  state_.divider = std::clamp(inPicture({io.MousePos.x / io.DisplaySize.x, 0}).x, 0.02f, 0.98f);
  if (!ImGui::IsMouseDown(ImGuiMouseButton_Left)) dragging_divider_ = false;
}

NoticeData Viewer::notice() {
  const double lasts = message_is_failure_ ? kFailureSeconds : kMessageSeconds;
  if (since_message_.seconds() > lasts) message_.clear();
  NoticeData notice;
  notice.left = pictureLeft();
  notice.message = message_;
  notice.failure = message_is_failure_;
  notice.can_cancel = scene_ != nullptr;
  if (loading_) {
    notice.loading = loading_choice_->path.filename().string();
    notice.progress = loading_->progress();
  } else if (scene_ && canvas_.empty()) {
    notice.preparing = "the first picture";
  } else if (scene_ && beside_ && !canvas_.comparing()) {
    notice.preparing = "the comparison";
  }
  return notice;
}

void Viewer::fulfil(const PanelWishes& wishes) {
  if (wishes.open) open(*wishes.open);
  if (wishes.variant) chooseVariant(*wishes.variant);
  if (wishes.camera) chooseCamera(*wishes.camera);
  if (wishes.lens) {
    camera_.setLens(*wishes.lens);
    asked_ = true;
  }
  if (wishes.environment) chooseEnvironment(*wishes.environment);
  if (wishes.save_picture) savePicture(*wishes.save_picture);
  if (wishes.save_scene) saveScene();
  if (wishes.copy_command) copyCommand();
  if (wishes.measure_limits) measureLimits();
  if (wishes.measure_effects) measureEffects();
  if (wishes.cancel_saving && saving_) saving_->cancel();
  if (wishes.undo && history_) step(history_->undo());
  if (wishes.redo && history_) step(history_->redo());
  if (wishes.compare) compare();
  if (wishes.frame) frame();
  if (wishes.reset) press({Key::r});
}

void Viewer::updateTitle() {
  if (since_title_.seconds() < kTitleSeconds) return;
  since_title_ = {};
  const std::string name = scene_ ? scene_->scene.name : "loading";
  const bool changed = scene_ && state_.look != saved_look_;
  const std::string typing = gui_.wantsKeys() ? ", typing" : "";
  const double rate = status_.sample_rate;
  const std::string size = status_.divisor > 1 ? fmt::format(", 1/{} size", status_.divisor) : "";
  const std::string title =
      printable(fmt::format("{}{} - {}, {:.{}f} samples/s{}{} - glimt", name, changed ? "*" : "",
                            counted(static_cast<std::uintmax_t>(status_.samples), "sample"), rate,
                            rate < 10 ? 1 : 0, size, typing));
  if (title != title_) window_.setTitle(title);
  title_ = title;
}

void Viewer::tell(const std::string& text, bool failure) {
  const std::string message = printable(text);
  // What goes wrong each time the hand moves is said once.
  if (!failure || message != message_) say(text);
  message_ = message;
  message_is_failure_ = failure;
  since_message_ = {};
  frames_wanted_ = kFramesOfEvent;
}

// The panel's share of the window's width. A narrow window has no room for both: there it lies on
// the picture.
float Viewer::pictureLeft() const {
  const auto width = static_cast<float>(window_.size()[0]);
  const float panel = state_.panel ? panelWidth(width) : 0;
  return 2 * panel < width ? panel / width : 0;
}

std::array<int, 2> Viewer::pictureSize() const {
  const auto [width, height] = window_.framebufferSize();
  const long columns = std::lround(static_cast<float>(width) * (1 - pictureLeft()));
  return {std::max(static_cast<int>(columns), 1), height};
}

// A place in the window, as shares of the picture's width and height.
Vec2 Viewer::inPicture(Vec2 at) const {
  const float left = pictureLeft();
  return {(at.x - left) / (1 - left), at.y};
}

float Viewer::aspect() const {
  const auto [width, height] = pictureSize();
  return static_cast<float>(width) / static_cast<float>(height);
}

}  // namespace glimt
