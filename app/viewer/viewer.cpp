#include "app/viewer/viewer.h"

#include <fmt/format.h>

#include "app/message.h"
#include "app/viewer/snapshot_name.h"
#include "renderer/core/error.h"
#include "renderer/core/image_file.h"
#include "renderer/core/wording.h"

namespace glimt {
namespace {

constexpr double kFrameSeconds = 1.0 / 30;
constexpr double kTitleSeconds = 0.25;
constexpr double kMessageSeconds = 4;

// How long camera and window are left alone before the picture is drawn in full.
constexpr double kRestSeconds = 0.25;

// Nobody sees the noise of more: the viewer then rests.
constexpr int kMostSamples = 65536;

}  // namespace

Viewer::Viewer(Window& window, Renderer& renderer, const ViewerSettings& settings)
    : window_(window),
      renderer_(renderer),
      settings_(settings),
      orbit_(settings.camera),
      window_size_(window.framebufferSize()) {
  window_.listen(*this);
}

void Viewer::run() {
  while (!window_.closing()) {
    handleEvents();
    if (window_.minimized()) continue;
    noteResize();
    startPictures();
    work();
    show();
    saveWhenReady();
    updateTitle();
  }
}

void Viewer::handleEvents() {
  if (window_.minimized()) {
    window_.waitEvents();
  } else if (finished()) {
    window_.waitEvents(kTitleSeconds);
  } else {
    window_.pollEvents();
  }
}

void Viewer::orbit(Vec2 drag) noexcept {
  orbit_.orbit(drag);
  change();
}

void Viewer::pan(Vec2 drag) noexcept {
  orbit_.pan(drag);
  change();
}

void Viewer::zoom(float steps) noexcept {
  orbit_.zoom(steps);
  change();
}

void Viewer::reset() noexcept {
  orbit_.reset();
  change();
}

void Viewer::change() {
  changed_ = true;
  since_change_ = {};
  message_.clear();
}

void Viewer::noteResize() {
  const std::array<int, 2> size = window_.framebufferSize();
  if (size == window_size_) return;
  window_size_ = size;
  change();
}

void Viewer::startPictures() {
  const bool has_sample = renderer_.samples() > 0;
  if (changed_) {
    // A hand that never rests would see nothing if it could end previews before their first sample.
    if (picture_ == Picture::preview && !has_sample) return;
    changed_ = false;
    picture_ = Picture::preview;
    startPicture(preview_scale_.divisorFor(static_cast<double>(window_size_[0]) * window_size_[1]));
  } else if (picture_ == Picture::preview && has_sample && since_change_.seconds() > kRestSeconds) {
    picture_ = Picture::full;
    if (divisor_ > 1) startPicture(1);
  }
}

void Viewer::startPicture(int divisor) {
  const auto reduced = [&](int side) { return (side + divisor - 1) / divisor; };
  renderer_.resize(reduced(window_size_[0]), reduced(window_size_[1]));
  renderer_.setCamera(orbit_.camera());
  divisor_ = divisor;
  work_seconds_ = 0;
  sample_seconds_ = 0;
  shown_samples_ = 0;
}

void Viewer::work() {
  const double pixels =
      static_cast<double>(window_size_[0]) * window_size_[1] / divisor_ / divisor_;
  const Stopwatch frame;
  while (frame.seconds() < kFrameSeconds && !finished()) {
    const int before = renderer_.samples();
    const Stopwatch clock;
    renderer_.advance(kFrameSeconds - frame.seconds(), before + 1);
    work_seconds_ += clock.seconds();
    sample_seconds_ += clock.seconds();
    if (renderer_.samples() == before) continue;
    preview_scale_.learn(pixels, sample_seconds_);
    sample_seconds_ = 0;
    if (before == 0) break;  // it is waited for
  }
}

bool Viewer::finished() const {
  return !changed_ && picture_ == Picture::full && renderer_.samples() >= kMostSamples;
}

// The window keeps the last picture until the next one has a sample.
void Viewer::show() {
  const int samples = renderer_.samples();
  if (samples == 0 || (samples == shown_samples_ && !damaged_)) return;
  if (shown_samples_ > 0 && since_shown_.seconds() < kFrameSeconds) return;
  if (!visible_) window_.show();
  visible_ = true;
  renderer_.present(window_size_[0], window_size_[1], settings_.exposure, settings_.tone);
  window_.swapBuffers();
  shown_samples_ = samples;
  damaged_ = false;
  since_shown_ = {};
}

void Viewer::saveWhenReady() {
  if (!save_asked_ || changed_ || picture_ != Picture::full || renderer_.samples() == 0) return;
  save_asked_ = false;
  try {
    const std::filesystem::path file = snapshotName(settings_.name);
    writeDisplayImage(file, renderer_.display(settings_.exposure, settings_.tone));
    message_ = fmt::format("saved {}", file.string());
    say(fmt::format("{}, {}", message_, counted(renderer_.samples(), "sample")));
  } catch (const Error& error) {
    message_ = "the picture could not be saved";
    say(error.what());
  }
  since_message_ = {};
  showTitle();
}

std::string Viewer::progress() const {
  const int samples = renderer_.samples();
  const double rate = samples > 0 ? samples / work_seconds_ : 0;
  const std::string size = divisor_ > 1 ? fmt::format(", 1/{} size", divisor_) : "";
  return fmt::format("{}, {:.{}f} samples/s{}", counted(samples, "sample"), rate, rate < 10 ? 1 : 0,
                     size);
}

void Viewer::updateTitle() {
  if (since_title_.seconds() < kTitleSeconds) return;
  if (since_message_.seconds() > kMessageSeconds) message_.clear();
  showTitle();
}

void Viewer::showTitle() {
  const std::string title = printable(
      fmt::format("{} - {} - glimt", settings_.name, message_.empty() ? progress() : message_));
  if (title != title_) window_.setTitle(title);
  title_ = title;
  since_title_ = {};
}

}  // namespace glimt
