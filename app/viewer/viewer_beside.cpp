// What the viewer has worked on beside the window.
#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "app/viewer/beside_work.h"
#include "app/viewer/viewer.h"
#include "renderer/core/error.h"
#include "renderer/core/image_file.h"
#include "renderer/core/wording.h"

namespace glimt {
namespace {

// In which nothing changes, before what is selected is outlined.
constexpr double kRestSeconds = 0.3;
constexpr int kOutlineDivisor = 2;

// Of a measurement that is done, and not of what is not shown any more.
template <typename Result>
std::optional<Result> takeFrom(std::unique_ptr<BackgroundTask<Result>>& task) {
  const auto done = std::move(task);
  std::optional<Result> result = done->take();
  if (done->cancelled()) result.reset();
  return result;
}

}  // namespace

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
    if (measuring_ && measuring_->done()) limits_ = takeFrom(measuring_);
    if (costing_ && costing_->done()) effect_costs_ = takeFrom(costing_);
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

void Viewer::measureEffects() {
  if (!scene_ || costing_) return;
  costing_ = std::make_unique<BackgroundTask<EffectCosts>>(
      [picture = besidePicture(request_.size)](const WorkProgress& progress) {
        return effectCostsOf(picture, progress);
      },
      Window::wake);
}

// Of what is not shown any more.
void Viewer::forgetMeasured() {
  limits_.reset();
  effect_costs_.reset();
  if (measuring_) measuring_->cancel();
  if (costing_) costing_->cancel();
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

}  // namespace glimt
