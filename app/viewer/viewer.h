// The viewer: events change what is asked for, threads work on it, and what they have done is
// shown.
#pragma once

#include <array>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>

#include "app/picture_settings.h"
#include "app/viewer/background_task.h"
#include "app/viewer/beside_work.h"
#include "app/viewer/canvas.h"
#include "app/viewer/gui.h"
#include "app/viewer/history.h"
#include "app/viewer/orbit_camera.h"
#include "app/viewer/outline.h"
#include "app/viewer/pace.h"
#include "app/viewer/panel/panel.h"
#include "app/viewer/render_thread.h"
#include "app/viewer/window.h"

namespace glimt {

class Viewer final : private WindowListener {
 public:
  // `picture` is what the command line asks for; of the scenes that are opened later, too. The
  // window outlives the viewer. Errors: no_gl.
  Viewer(Window& window, const PictureOptions& picture);

  // Until the window is closed. Errors: those of the first scene.
  void run(const SceneChoice& first);

  const Pace& pace() const { return pace_; }

 private:
  // Of the window.
  void orbit(Vec2 drag) noexcept override;
  void pan(Vec2 drag) noexcept override;
  void turnLight(Vec2 drag) noexcept override;
  void zoom(float steps, Vec2 at) noexcept override;
  void click(Vec2 at) noexcept override;
  void doubleClick(Vec2 at) noexcept override;
  void press(const KeyPress& key) noexcept override;
  void open(const std::filesystem::path& dropped) noexcept override;
  bool covered(Vec2 at) noexcept override;

  void pressControl(Key key);
  void pressPlain(const KeyPress& key);

  // A turn of the loop.
  void handleEvents();
  void takeResults();
  void takeScene();
  void takeOutline();
  void takeFinished();
  void watchFile();
  void turnTable();
  void ask();
  void draw();
  void moveDivider();
  NoticeData notice();
  void fulfil(const PanelWishes& wishes);
  void updateTitle();

  // What wishes and keys do.
  void load(const SceneChoice& choice);
  void show(std::shared_ptr<const LoadedScene> loaded);
  void remember(const LoadedScene& loaded);
  void chooseVariant(const std::string& variant);
  void chooseCamera(std::size_t index);
  void chooseEnvironment(const std::string& name);
  void frame();
  void step(const Look& look);
  void compare();
  void saveScene();
  void copyCommand();
  void measureLimits();
  void measureEffects();
  void forgetMeasured();
  void savePicture(const SavedPicture& picture);
  void tell(const std::string& text, bool failure = false);
  BesidePicture besidePicture(std::array<int, 2> size) const;
  std::optional<Vec3> pointAt(Vec2 at) const;
  float pictureLeft() const;
  std::array<int, 2> pictureSize() const;
  Vec2 inPicture(Vec2 at) const;
  float aspect() const;

  Window& window_;
  PictureOptions options_;
  Gui gui_;
  Canvas canvas_;
  RenderThread renderer_;
  Pace pace_;

  // What is shown.
  std::shared_ptr<const LoadedScene> scene_;
  OrbitCamera camera_;
  ViewerState state_;
  Look file_look_;   // as the file has it
  Look saved_look_;  // as it was saved last, or opened
  std::optional<History<Look>> history_;
  std::optional<View> beside_;
  std::vector<std::filesystem::path> recent_;
  std::filesystem::file_time_type refused_;  // when the file was written that was read last
  std::filesystem::path saved_scene_;  // that this viewer has written, of the scene that is open
  PanelFields fields_;

  // What was asked for.
  PictureRequest request_;
  std::optional<std::uint64_t> shown_serial_;      // of the picture that is to be drawn next
  std::optional<std::filesystem::path> snapshot_;  // to be saved, of what is asked for by then
  bool asked_ = false;                             // something was changed that has to be asked for
  double event_age_ = 0;    // seconds, at most, of the events that are handled now
  Stopwatch since_events_;  // since the last were handled
  Stopwatch since_change_;  // since the camera or the look was changed
  Stopwatch since_turn_;    // of the turntable
  Stopwatch since_watch_;   // of the file
  Stopwatch since_title_;
  int frames_wanted_ = 3;  // to be drawn, even if nothing happens
  bool dragging_divider_ = false;

  // Work beside the window.
  std::optional<SceneChoice> loading_choice_;
  std::unique_ptr<BackgroundTask<LoadedScene>> loading_;
  std::unique_ptr<BackgroundTask<Outline>> outlining_;
  bool outline_wanted_ = false;
  std::unique_ptr<BackgroundTask<LimitError>> measuring_;
  std::unique_ptr<BackgroundTask<EffectCosts>> costing_;
  std::unique_ptr<BackgroundTask<std::string>> saving_;  // gives what is told when it is done

  PictureStatus status_;
  NoiseHistory noise_;
  std::optional<LimitError> limits_;
  std::optional<EffectCosts> effect_costs_;
  std::string message_;
  bool message_is_failure_ = false;
  Stopwatch since_message_;
  std::string title_;
};

}  // namespace glimt
