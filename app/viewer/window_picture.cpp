#include "app/viewer/window_picture.h"

#include <utility>

namespace glimt {
namespace {

// How long everything is left alone before the picture is drawn in full.
constexpr double kRestSeconds = 0.2;

// Nobody sees the noise of more: the viewer then rests.
constexpr int kMostSamples = 65536;

// Times the samples that a denoised picture was made of, before the next: the denoiser takes as
// long as several samples.
constexpr double kMoreToDenoise = 1.5;

bool sameCamera(const Camera& a, const Camera& b) {
  return a.position == b.position && a.target == b.target && a.up == b.up &&
         a.vertical_fov == b.vertical_fov && a.orthographic_height == b.orthographic_height &&
         a.aperture_radius == b.aperture_radius && a.focus_distance == b.focus_distance &&
         a.aperture_blades == b.aperture_blades;
}

bool sameSurfaces(const Look& a, const Look& b) {
  return a.materials == b.materials && a.environment_strength == b.environment_strength &&
         a.environment_rotation == b.environment_rotation;
}

}  // namespace

void WindowPicture::ask(const View& view, const Camera& camera, std::array<int, 2> size,
                        std::uint64_t serial) {
  const bool same = view.scene == view_.scene && sameLight(view.look, view_.look) &&
                    sameCamera(camera, camera_) && size == size_;
  view_ = view;
  camera_ = camera;
  size_ = size;
  asked_serial_ = serial;
  if (same) return;
  changed_ = true;
  since_change_ = {};
}

void WindowPicture::work(double seconds) {
  begin();
  const Stopwatch frame;
  while (renderer_ && frame.seconds() < seconds && !finished()) {
    const int before = samples();
    const Stopwatch clock;
    renderer_->advance(seconds - frame.seconds(), before + 1);
    work_seconds_ += clock.seconds();
    sample_seconds_ += clock.seconds();
    if (samples() == before) continue;
    preview_scale_.learn(pixels(), sample_seconds_);
    sample_seconds_ = 0;
    if (before == 0) break;  // it is waited for
  }
}

void WindowPicture::begin() {
  const bool has_sample = samples() > 0;
  if (changed()) {
    // A hand that never rests would see nothing if it could end previews before their first sample.
    const bool same_scene = view_.scene == drawn_.scene;
    if (stage_ == Stage::preview && !has_sample && same_scene) return;
    changed_ = false;
    begun_serial_ = asked_serial_;
    begun_size_ = size_;
    takeView();
    stage_ = renderer_ ? Stage::preview : Stage::none;
    const double full = static_cast<double>(size_[0]) * size_[1];
    if (renderer_) start(preview_scale_.divisorFor(full));
  } else if (stage_ == Stage::preview && has_sample && since_change_.seconds() > kRestSeconds) {
    sharpen();
  }
}

// A sample of the whole may take seconds: what is between it and a small preview is quick to see,
// and all of it together takes a third of that.
void WindowPicture::sharpen() {
  const int next = divisor_ / 2;
  if (next > 1) return start(next);
  stage_ = Stage::full;
  if (divisor_ > 1) start(1);
}

// Gives the renderer the scene and the look that are asked for.
void WindowPicture::takeView() {
  const Look& look = view_.look;
  const View before = std::exchange(drawn_, view_);
  if (!view_.scene) {
    renderer_.reset();
    scene_ = {};
    return;
  }
  if (before.scene != view_.scene) scene_ = view_.scene->scene;
  scene_.camera = camera_;
  apply(look, scene_);
  effects_are_old_ = true;
  const bool same_triangles =
      before.scene && before.scene->tree.shared() == view_.scene->tree.shared();
  if (!renderer_ || !same_triangles) {
    renderer_.reset();  // two would take twice the memory
    RenderSettings settings = settings_;
    settings.bounces = look.bounces;
    settings.width = settings.height = 1;
    renderer_.emplace(context_, scene_, view_.scene->tree, settings);
    return;
  }
  if (before.scene != view_.scene)
    renderer_->setMaterials(scene_);
  else if (!sameSurfaces(look, before.look))
    renderer_->setMaterials(scene_, MaterialChange::numbers);
  if (look.bounces != before.look.bounces) renderer_->setLimits({look.bounces, settings_.clamp});
}

void WindowPicture::start(int divisor) {
  const auto reduced = [&](int side) { return (side + divisor - 1) / divisor; };
  renderer_->resize(reduced(size_[0]), reduced(size_[1]));
  renderer_->setCamera(camera_);
  divisor_ = divisor;
  work_seconds_ = 0;
  sample_seconds_ = 0;
  shown_samples_ = 0;
}

double WindowPicture::pixels() const {
  return static_cast<double>(size_[0]) * size_[1] / divisor_ / divisor_;
}

bool WindowPicture::finished() const {
  return !changed() && (!renderer_ || (stage_ == Stage::full && samples() >= kMostSamples));
}

bool WindowPicture::denoises() const {
  return view_.denoise && stage_ == Stage::full;
}

bool WindowPicture::hasNews() const {
  if (samples() == 0) return false;
  if (shown_samples_ == 0 || shown_exposure_ != view_.look.exposure ||
      shown_tone_ != view_.look.tone || shown_denoised_ != denoises())
    return true;
  const double more = denoises() ? kMoreToDenoise * shown_samples_ : shown_samples_ + 1;
  return samples() >= more;
}

DisplayImage WindowPicture::frame() {
  shown_samples_ = samples();
  shown_exposure_ = view_.look.exposure;
  shown_tone_ = view_.look.tone;
  shown_denoised_ = denoises();
  return renderer_->display(shown_exposure_, shown_tone_,
                            shown_denoised_ ? Shown::denoised : Shown::samples);
}

PictureStatus WindowPicture::status() {
  PictureStatus status;
  if (!renderer_) return status;
  status.samples = samples();
  status.divisor = divisor_;
  status.seconds = work_seconds_;
  status.sample_rate = status.samples > 0 && work_seconds_ > 0 ? status.samples / work_seconds_ : 0;
  if (stage_ == Stage::full) {
    status.noise = renderer_->noise();
    if (std::exchange(effects_are_old_, false)) effects_ = reportEffects(scene_);
  }
  status.effects = effects_;
  status.statistics = renderer_->statistics();
  return status;
}

}  // namespace glimt
