// A picture that follows what is asked for: previews while that changes, then the whole.
#pragma once

#include <array>
#include <memory>
#include <optional>
#include <vector>

#include "app/stopwatch.h"
#include "app/viewer/loaded_scene.h"
#include "app/viewer/look.h"
#include "app/viewer/preview_scale.h"
#include "renderer/renderer.h"
#include "renderer/scene/effects_of.h"

namespace glimt {

// What a picture is of.
struct View {
  std::shared_ptr<const LoadedScene> scene;  // null: of nothing
  Look look;
  bool denoise = false;  // as it is shown; what is saved is what the samples show
};

// How far a picture is.
struct PictureStatus {
  int samples = 0;
  int divisor = 1;         // of its width and height: more than 1 for a preview
  double seconds = 0;      // spent on it
  double sample_rate = 0;  // samples a second
  std::optional<NoiseEstimate> noise;
  std::vector<EffectReport> effects;  // of the last picture that was no preview
  RenderStatistics statistics;

  double secondsPerSample() const { return sample_rate > 0 ? 1 / sample_rate : 0; }
};

class WindowPicture {
 public:
  // The context outlives the picture. `settings` holds what a look does not.
  WindowPicture(ContextHandle& context, const RenderSettings& settings)
      : context_(context), settings_(settings) {}

  // May be asked for at any time, the same again too: then the picture goes on. `serial` rises from
  // one time to the next.
  void ask(const View& view, const Camera& camera, std::array<int, 2> size, std::uint64_t serial);

  // Works for about so long. Errors: those of the renderer, after which the picture is of no more
  // use.
  void work(double seconds);

  // Whether there is nothing left to do: nobody sees the noise of more samples.
  bool finished() const;

  // Whether there is a sample, or another way to display them, that frame() has not given yet.
  // Denoised a picture is given again when it has half as many samples more, and a preview is not
  // denoised.
  bool hasNews() const;
  // Whether it is the first of what was asked for last, which somebody waits for.
  bool isFirst() const { return shown_samples_ == 0; }
  DisplayImage frame();

  // Of the latest time of asking that the picture answers.
  std::uint64_t serial() const { return changed() ? begun_serial_ : asked_serial_; }

  // Of the picture in full, in pixels.
  std::array<int, 2> size() const { return begun_size_; }

  bool full() const { return stage_ == Stage::full && !changed() && samples() > 0; }

  int samples() const { return renderer_ ? renderer_->samples() : 0; }
  PictureStatus status();
  Renderer& renderer() { return *renderer_; }

 private:
  enum class Stage { none, preview, full };

  void begin();
  void takeView();
  void sharpen();
  void start(int divisor);
  double pixels() const;
  bool changed() const { return changed_; }
  bool denoises() const;

  ContextHandle& context_;
  RenderSettings settings_;
  View view_;
  Camera camera_;
  std::array<int, 2> size_{1, 1};
  std::array<int, 2> begun_size_{1, 1};
  Stopwatch since_change_;
  bool changed_ = false;  // since the picture was begun
  std::uint64_t asked_serial_ = 0;
  std::uint64_t begun_serial_ = 0;

  std::optional<Renderer> renderer_;
  Scene scene_;  // as the renderer has it
  View drawn_;   // which that is
  std::vector<EffectReport> effects_;
  bool effects_are_old_ = false;  // of what was drawn before
  PreviewScale preview_scale_;
  Stage stage_ = Stage::none;
  int divisor_ = 1;
  double work_seconds_ = 0;    // spent on the picture
  double sample_seconds_ = 0;  // spent on its next sample

  int shown_samples_ = 0;
  float shown_exposure_ = 0;
  Tone shown_tone_ = Tone::srgb;
  bool shown_denoised_ = false;
};

}  // namespace glimt
