// The viewer's loop: events, a bit of work, the picture, the title.
#pragma once

#include <array>
#include <string>

#include "app/stopwatch.h"
#include "app/viewer/orbit_camera.h"
#include "app/viewer/preview_scale.h"
#include "app/viewer/window.h"
#include "renderer/renderer.h"

namespace glimt {

struct ViewerSettings {
  std::string name;  // of the scene
  Camera camera;
  float exposure = 0;  // EV
  Tone tone = Tone::srgb;
};

// While the camera moves or the window's size does, previews are drawn, each of its own camera; the
// full picture is for the time after. What the window shows stays until there is something newer.
class Viewer final : private WindowListener {
 public:
  // All of them outlive the viewer.
  Viewer(Window& window, Renderer& renderer, const ViewerSettings& settings);

  // Until the window is closed.
  void run();

 private:
  void orbit(Vec2 drag) noexcept override;
  void pan(Vec2 drag) noexcept override;
  void zoom(float steps) noexcept override;
  void reset() noexcept override;
  void save() noexcept override { save_asked_ = true; }
  void redraw() noexcept override { damaged_ = true; }

  void handleEvents();
  void noteResize();
  void startPictures();
  void startPicture(int divisor);
  void work();
  void show();
  void saveWhenReady();
  void updateTitle();

  void change();
  bool finished() const;
  void showTitle();
  std::string progress() const;

  Window& window_;
  Renderer& renderer_;
  const ViewerSettings& settings_;
  OrbitCamera orbit_;
  PreviewScale preview_scale_;

  std::array<int, 2> window_size_;  // in pixels
  bool changed_ = true;             // the camera or the size, since the picture was started
  Stopwatch since_change_;

  enum class Picture { none, preview, full };
  Picture picture_ = Picture::none;  // that is being made
  int divisor_ = 1;                  // of its width and height
  double work_seconds_ = 0;          // spent on it
  double sample_seconds_ = 0;        // spent on its next sample

  int shown_samples_ = 0;  // of this picture; 0: the window shows an earlier one
  bool visible_ = false;
  bool damaged_ = false;
  Stopwatch since_shown_;

  bool save_asked_ = false;
  std::string message_;
  Stopwatch since_message_;
  std::string title_;
  Stopwatch since_title_;
};

}  // namespace glimt
